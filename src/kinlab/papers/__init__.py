"""What the papers print, evaluated as it stands, beside what is true."""

"""The Lessons station: the course, text beside the instrument that it talks about, and exercises that are checked."""

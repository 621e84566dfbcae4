"""What stands in for the terminal in a session that is served to a browser."""

from textual import messages
from textual.drivers.web_driver import WebDriver


class GuestDriver(WebDriver):
    """Textual's driver for browsers, which ends the program when the server is gone, however it went."""

    def run_input_thread(self) -> None:
        """Listen to the server until it falls silent for good."""
        super().run_input_thread()
        if not self.exit_event.is_set():
            self._app.post_message(messages.ExitApp())

"""What stands in for the terminal in a session that is served to a browser."""

from textual.drivers.web_driver import WebDriver
from textual.events import AppFocus, Resize
from textual.message import Message


class GuestDriver(WebDriver):
    """Textual's driver for browsers, with an end like any other's: what was chosen is kept, however the end came."""

    def start_application_mode(self) -> None:
        """Begin with the focus, which the page takes; Textual's own begins without, and shows no cursor."""
        super().start_application_mode()
        self._app.call_later(self._app.post_message, AppFocus())

    def process_message(self, message: Message) -> None:
        """Pass on what is typed and clicked, and no size: that comes from the server alone, which bounds it."""
        if not isinstance(message, Resize):
            super().process_message(message)

    def on_meta(self, packet_type: str, payload: dict[str, object]) -> None:
        """Do what the server asks for; to quit is to leave as by the key."""
        if packet_type == "quit":
            self._leave()
        else:
            super().on_meta(packet_type, payload)

    def run_input_thread(self) -> None:
        """Listen to the server until it falls silent for good; then there is nobody to stay for."""
        super().run_input_thread()
        if not self.exit_event.is_set():
            self._leave()

    def _leave(self) -> None:
        self._app.call_later(self._app.exit)

"""What can go wrong on a bus, each naming the servo, the register and the cause."""

from kinlab.errors import KinlabError


class BusError(KinlabError):
    """A request to a servo failed.

    Attributes:
        servo: the id that was asked.
        subject: the register, or the instruction, that it was about.
        cause: what went wrong.
    """

    def __init__(self, servo: int, subject: str, cause: str) -> None:
        super().__init__(f"servo {servo}, {subject}: {cause}")
        self.servo = servo
        self.subject = subject
        self.cause = cause


class NoAnswerError(BusError):
    """Nothing came back in time."""

    def __init__(self, servo: int, subject: str) -> None:
        super().__init__(servo, subject, "no answer (wrong id, baud rate or protocol, or no power?)")


class DamagedAnswerError(BusError):
    """Bytes came back, but no intact packet of that servo."""

    def __init__(self, servo: int, subject: str, data: bytes) -> None:
        super().__init__(servo, subject, f"a damaged answer: {data.hex(' ').upper()}")


class RefusedError(BusError):
    """The servo answered that it did not do it.

    Attributes:
        error: the error byte of its answer.
    """

    def __init__(self, servo: int, subject: str, error: int, names: list[str]) -> None:
        super().__init__(servo, subject, f"the servo reports: {', '.join(names)}")
        self.error = error

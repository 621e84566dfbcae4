"""The stations, in the order in which a student meets them: name, and the class to be imported when it is opened."""

STATIONS: dict[str, str] = {
    "robot": "kinlab.tui.stations.robot.station:RobotStation",
    "gait": "kinlab.tui.stations.gait.station:GaitStation",
    "packet": "kinlab.tui.stations.packet.station:PacketStation",
    "arm": "kinlab.tui.stations.arm.station:ArmStation",
    "lessons": "kinlab.tui.stations.lessons.station:LessonsStation",
}

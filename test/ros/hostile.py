"""Messages of broken drivers, clocks and transforms for a mapper; none may change a map."""

import random

import geometry_msgs.msg
import rospy
import sensor_msgs.msg
import tf2_msgs.msg
import wireless_msgs.msg
from structure_from_wifi.msg import ApReading, WifiScan

NAN, INFINITY = float("nan"), float("inf")


def reading(bssid, rssi_dbm=-50.0, age_s=0.0):
    return ApReading(bssid=bssid, ssid="home", rssi_dbm=rssi_dbm, age_s=age_s)


class HostileMessages:
    """Publishes one at a time, of a random kind."""

    def __init__(self, known, seed=1):
        self.known = known
        self.random = random.Random(seed)
        topics = {"wifi_scan": WifiScan, "connection": wireless_msgs.msg.Connection,
                  "contact_points": sensor_msgs.msg.PointCloud2, "/tf": tf2_msgs.msg.TFMessage}
        self.publishers = {topic: rospy.Publisher(topic, kind, queue_size=10)
                           for topic, kind in topics.items()}

    def send(self, now):
        topic, make = self.random.choice([("wifi_scan", self.scan), ("connection", self.connection),
                                          ("contact_points", self.cloud), ("/tf", self.transform)])
        self.publishers[topic].publish(make(now))

    def scan(self, now):
        pick = self.random.choice
        scan = WifiScan()
        scan.header.stamp = now
        no_signal = pick((NAN, INFINITY, -INFINITY, 70.0, 100.0, 1.0, -120.0, -1000.0))
        no_address = pick(("", "02:00:00:00:00", "02:00:00:00:00:0g", "f" * 100000))
        long_ago = rospy.Duration(500)
        kind = self.random.randrange(6)
        if kind == 0:
            scan.readings = [reading(self.known, no_signal), reading(no_address),
                             reading(self.known, age_s=pick((NAN, INFINITY, -1.0, 1e9)))]
        elif kind == 1:
            scan.header.stamp = rospy.Time()
            scan.readings = [reading(self.known, no_signal)]
        elif kind == 2:
            scan.header.stamp = rospy.Time(max(1, now.to_sec() - long_ago.to_sec()))
            scan.readings = [reading(self.known)]
        elif kind == 3:
            scan.header.stamp = pick((now + long_ago, rospy.Time(4000000000)))
            scan.readings = [reading(self.known)]
        elif kind == 4:
            scan.readings = [reading(no_address[:17])] * 10000
        return scan

    def connection(self, _):
        pick = self.random.choice
        if self.random.random() < 0.5:
            return wireless_msgs.msg.Connection(bssid=pick(("", "Not-Associated")), signal_level=-50)
        return wireless_msgs.msg.Connection(bssid=self.known,
                                            signal_level=pick((0, 70, 200, -256, 32767)))

    def cloud(self, now):
        pick = self.random.choice
        cloud = sensor_msgs.msg.PointCloud2(height=1, width=3, point_step=12, row_step=36,
                                            data=bytes(36))
        cloud.header.stamp, cloud.header.frame_id = now, "base_link"
        cloud.fields = [sensor_msgs.msg.PointField(name, 4 * i, 7, 1)
                        for i, name in enumerate("xyz")]
        kind = self.random.randrange(5)
        if kind == 0:
            cloud.data = cloud.data[:pick((0, 5, 35))]
        elif kind == 1:
            cloud.width = cloud.height = 4294967295
        elif kind == 2:
            cloud.point_step = pick((0, 1, 4, 4294967295))
        elif kind == 3:
            cloud.fields[1].offset = pick((9, 1000000, 4294967295))
        else:
            cloud.header.frame_id = pick(("nowhere", ""))
        return cloud

    def transform(self, now):
        pick = self.random.choice
        broken = geometry_msgs.msg.TransformStamped()
        broken.header.stamp, broken.header.frame_id, broken.child_frame_id = now, "odom", "base_link"
        broken.transform.rotation.w = 1.0
        kind = self.random.randrange(3)
        if kind == 0:
            broken.transform.translation.x = NAN
        elif kind == 1:
            broken.transform.rotation.z = pick((NAN, INFINITY, 0.5))
        else:
            broken.header.frame_id = pick(("", "base_link"))
        return tf2_msgs.msg.TFMessage([broken])

"""Writes readings to a bag as a robot would have recorded them."""

import collections
import math

import genpy
import rosbag
from geometry_msgs.msg import TransformStamped
from structure_from_wifi.msg import ApReading, WifiScan
from tf2_msgs.msg import TFMessage

# Readings taken at one place and time; stamp_ns whole, x and y in the map frame.
Stop = collections.namedtuple("Stop", "stamp_ns x y readings")

ODOM_IN_MAP = (1.3, -2.1, 0.4)  # x, y, yaw: some place other than the map's origin
TF_STEP_NS = 20000000  # from a scan to the transforms before and after it
LATE_NS = 200000000


def synthetic_stops(count=150, step_ns=50000003, start_ns=100123456789):
    """A drive past a wall with two access points, stamped to the nanosecond."""
    stops = []
    for i in range(count):
        x, y = round(1.0 + 0.04 * i, 4), round(2.0 + 0.5 * math.sin(0.07 * i), 4)
        noise = (i * 7919 % 13 - 6) * 0.25
        readings = [("02:00:00:00:00:01", (-58.0 if i > count // 2 else -40.0) + noise),
                    ("02:00:00:00:00:02", (-41.0 if i > count // 3 else -60.0) - noise)]
        stops.append(Stop(start_ns + i * step_ns, x, y, readings))
    return stops


def recorded_stops(file, seconds):
    """The stops of a readings.csv up to a time after its first one."""
    stops = []
    with open(file) as table:
        next(table)
        for line in table:
            stamp, x, y, bssid, rssi_dbm = line.strip().split(",")
            whole, _, fraction = stamp.partition(".")
            stamp_ns = int(whole) * 10**9 + int(fraction.ljust(9, "0")) + 10**9  # 0 is no stamp
            if not stops or stops[-1].stamp_ns != stamp_ns:
                stops.append(Stop(stamp_ns, float(x), float(y), []))
            if stamp_ns - stops[0].stamp_ns > seconds * 10**9:
                return stops[:-1]
            stops[-1].readings.append((bssid, float(rssi_dbm)))
    return stops


def write_csv(stops, file):
    with open(file, "w") as table:
        table.write("stamp,x,y,bssid,rssi_dbm\n")
        for stop in stops:
            for bssid, rssi_dbm in stop.readings:
                table.write("%d.%09d,%.4f,%.4f,%s,%.2f\n" % (
                    stop.stamp_ns // 10**9, stop.stamp_ns % 10**9, stop.x, stop.y, bssid,
                    rssi_dbm))


def time_of(stamp_ns):
    return genpy.Time(stamp_ns // 10**9, stamp_ns % 10**9)


def transform(stamp_ns, parent, child, x, y, yaw):
    message = TransformStamped()
    message.header.stamp = time_of(stamp_ns)
    message.header.frame_id, message.child_frame_id = parent, child
    message.transform.translation.x, message.transform.translation.y = x, y
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message


def base_in_odom(stamp_ns, x, y):
    odom_x, odom_y, yaw = ODOM_IN_MAP
    dx, dy = x - odom_x, y - odom_y
    return transform(stamp_ns, "odom", "base_link", math.cos(yaw) * dx + math.sin(yaw) * dy,
                     math.cos(yaw) * dy - math.sin(yaw) * dx, 0.3 - yaw)


def scan_of(stop):
    scan = WifiScan()
    scan.header.stamp = time_of(stop.stamp_ns)
    scan.header.frame_id = "base_link"
    scan.readings = [ApReading(bssid=bssid, rssi_dbm=rssi_dbm) for bssid, rssi_dbm in stop.readings]
    return scan


def odom_in_map(stamp_ns, shift_y=0.0):
    x, y, yaw = ODOM_IN_MAP
    return transform(stamp_ns, "map", "odom", x, y + shift_y, yaw)


def plain_messages(stops):
    """(received, topic, message): transforms before, at and after each scan, all in good order."""
    for stop in stops:
        for offset in (-TF_STEP_NS, 0, TF_STEP_NS):
            at = stop.stamp_ns + offset
            yield at, "/tf", TFMessage([odom_in_map(at), base_in_odom(at, stop.x, stop.y)])
        yield stop.stamp_ns + 1, "/wifi_scan", scan_of(stop)


def awkward_messages(stops):
    """The same drive: map -> odom static, transforms late, neighbouring scans swapped."""
    first = stops[0].stamp_ns
    yield first - LATE_NS, "/tf_static", TFMessage([odom_in_map(first)])
    for i, stop in enumerate(stops):
        # The pose is not sampled at the scan's stamp, only around it.
        for offset in (-TF_STEP_NS, TF_STEP_NS):
            at = stop.stamp_ns + offset
            yield at + LATE_NS, "/tf", TFMessage([base_in_odom(at, stop.x, stop.y)])
        partner = stops[min(i ^ 1, len(stops) - 1)]
        yield max(stop.stamp_ns, partner.stamp_ns) + i % 2, "/wifi_scan", scan_of(stop)


def corrected_messages(stops, drift=0.003):
    """The same drive by odometry that drifts in y, corrected at two thirds of the way."""
    closure = 2 * len(stops) // 3
    for i, stop in enumerate(stops):
        error = drift * min(i, closure)
        for offset in (-TF_STEP_NS, 0, TF_STEP_NS):
            at = stop.stamp_ns + offset
            yield at, "/tf", TFMessage([odom_in_map(at, -error if i >= closure else 0.0),
                                        base_in_odom(at, stop.x, stop.y + error)])
        yield stop.stamp_ns + 1, "/wifi_scan", scan_of(stop)


def slow_messages(stops, every):
    """The same drive with a scan only at some stops, and tf all the way."""
    for i, (received, topic, message) in enumerate(plain_messages(stops)):
        if topic == "/tf" or i // 4 % every == 0:
            yield received, topic, message


def write_bag(messages, file):
    with rosbag.Bag(str(file), "w") as bag:
        for received_ns, topic, message in sorted(messages, key=lambda entry: entry[0]):
            bag.write(topic, message, time_of(received_ns))

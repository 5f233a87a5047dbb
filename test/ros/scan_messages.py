"""The scan messages of other packages: definitions as their packages publish them, and an example.

Each entry of MESSAGES has a name, the type, its definition, the values of an example, and the
readings that must come of it: (BSSID, dBm, seconds).
"""

import json

A, B = "02:00:00:00:00:01", "02:00:00:00:00:0b"
BYTES_A, BYTES_B = [2, 0, 0, 0, 0, 1], [2, 0, 0, 0, 0, 11]
STAMPED, RECEIVED = 1000.25, 1000.5  # s; the second is for messages without a stamp

HEADER = "\n".join(["=" * 80, "MSG: std_msgs/Header", "# Standard metadata",
                    "uint32 seq", "time stamp  # when", "string frame_id", ""])
STAMP = {"stamp": {"secs": 1000, "nsecs": 250000000}, "frame_id": "antenna"}


def part(name, text):
    return "%s\nMSG: %s\n%s\n" % ("=" * 80, name, text)


NETWORK = "string macattr\nstring essid\nint32 channel\nint32 rssi\nint32 noise\nint32 beacon"
WIFI_CSI = """# This message accepts data from a WiFi access point for us in
std_msgs/Header header

uint8 ap_id # access point collecting the CSI
uint8[] txmac

uint8 chan # channel number
uint32 n_sub # number of subcarriers
uint8 n_rows
uint8 n_cols
uint8 bw
uint8 mcs
int32 rssi # received signal strength across "n_rows" antennas
uint32 fc # packet type byte
uint32 seq_num # packet number
float64[] csi_real # channel state information - real part
float64[] csi_imag
string rx_id #flag of receiver
uint32 msg_id #realtime msg for debug
"""
STATION = """#basic object which can be detected by wireless sensing.

Header header
uint8[6] mac
#string mac
int32 channel
int32 rssi"""
STATION_INFO = ("string bssid\nuint32 last_seen\nint8 signal\nfloat32 bitrate\nuint32 rx_pkts\n"
                "uint32 tx_pkts\nuint32 rx_bytes\nuint32 tx_bytes\n")


DIAGNOSTICS = ("Header header\nDiagnosticStatus[] status\n" + HEADER +
               part("diagnostic_msgs/DiagnosticStatus",
                    "byte OK=0\nbyte level\nstring name\nstring message\nstring hardware_id\n"
                    "KeyValue[] values") +
               part("diagnostic_msgs/KeyValue", "string key\nstring value"))
IW = """BSS %s(on wlan0) -- associated
\tlast seen: 83.250s [boottime]
\tTSF: 1000 usec (0d, 00:00:00)
\tfreq: 2437
\tsignal: -50.00 dBm
\tlast seen: 250 ms ago
\tSSID: a
\tBSS Load:
\t\t * station count: 3
BSS %s(on wlan0)
\tsignal: -61.50 dBm
\tlast seen: 0 ms ago
BSS 02:00:00:00:00:0c(on wlan0)
\tsignal: 70/100
""" % (A, B)
IWLIST = """wlan0     Scan completed :
          Cell 01 - Address: %s
                    Quality=60/70  Signal level=-50 dBm  \x20
                    ESSID:"a"
                    Extra: Last beacon: 250ms ago
          Cell 02 - Address: %s
                    Quality:49/70  Signal level:-61 dBm  Noise level:-95 dBm
          Cell 03 - Address: 02:00:00:00:00:0C
                    Quality=60/100  Signal level=60/100
""" % (A.upper(), B.upper())


def keys(**values):
    return {"values": [{"key": key, "value": value} for key, value in sorted(values.items())]}


def cabot(*data):
    return json.dumps({"type": "rssi", "phoneID": "robot", "timestamp": STAMPED, "data": data})


def site_survey(package):
    return ("survey of " + package, package + "/SiteSurvey",
            "Header header\n%s/Network[] networks\n" % package + HEADER +
            part(package + "/Network", NETWORK),
            {"header": STAMP, "networks": [
                {"macattr": A, "essid": "a", "channel": 6, "rssi": -50, "noise": -90},
                {"macattr": B, "essid": "b", "channel": 36, "rssi": -61, "noise": -90}]},
            [(A, -50, STAMPED), (B, -61, STAMPED)])


def sign_lost(name, kind, fields, values, part_fields):
    package = kind.split("/")[0]
    return (name, kind, fields + "\n" + part(package + "/Wifi", part_fields),
            values, [(A, -50, RECEIVED), (B, -61, RECEIVED)])


MESSAGES = [
    ("link", "wireless_msgs/Connection",
     "float32 bitrate\nint16 txpower\nstring link_quality_raw\nfloat32 link_quality\n"
     "int16 signal_level\nint16 noise_level\nstring essid\nstring bssid\nfloat64 frequency\n",
     {"signal_level": -50, "bssid": A.upper(), "frequency": 2.437},  # GHz
     [(A, -50, RECEIVED)]),
    ("link of pr2", "pr2_msgs/AccessPoint",
     "Header header\nstring essid\nstring macaddr\nint32 signal\nint32 noise\nint32 snr\n"
     "int32 channel\nstring rate\nstring tx_power\nint32 quality" + "\n" + HEADER,
     {"header": STAMP, "macaddr": A, "signal": -50, "channel": 6}, [(A, -50, STAMPED)]),
    ("link of jsk", "jsk_network_tools/WifiStatus",
     "Header header\nstring interface\nbool enabled\nbool connected\nstring ssid\n"
     "float32 frequency\nstring access_point\nfloat32 bitrate\nint16 tx_power\n"
     "float32 link_quality\nint16 signal_level\n" + HEADER,
     {"header": STAMP, "access_point": A, "signal_level": -50, "frequency": 2.437},
     [(A, -50, STAMPED)]),
    site_survey("wifi_ddwrt"), site_survey("access_point_control"),
    ("rss", "rss/RssData",  # no header, its own clock, several strengths of an access point
     "uint64      time_start_ns\nuint32      duration_ms\nstring[]    mac_address\n"
     "int16[]     freq\nRssDatum[]  data\n" + part("rss/RssDatum", "int8[]  rss"),
     {"time_start_ns": 1000 * 10**9, "duration_ms": 500, "mac_address": [A, B],
      "freq": [2412, 5180], "data": [{"rss": [-49, -51, 0, -50]}, {"rss": [-61]}]},
     [(A, -50, 1000.25), (B, -61, 1000.25)]),
    ("rss of another clock", "rss/RssData",
     "uint64 time_start_ns\nuint32 duration_ms\nstring[] mac_address\nint16[] freq\n"
     "RssDatum[] data\n" + part("rss/RssDatum", "int8[] rss"),
     {"time_start_ns": 10**14, "duration_ms": 0, "mac_address": [A], "freq": [2412],
      "data": [{"rss": [-50]}]},
     [(A, -50, RECEIVED)]),
    ("rf_msgs array", "rf_msgs/WifiDataArray", "#Header header\nrf_msgs/WifiData[] wifidata\n" +
     part("rf_msgs/WifiData", "string macaddress\nint16 strength"),
     {"wifidata": [{"macaddress": A, "strength": -50}, {"macaddress": B, "strength": -61}]},
     [(A, -50, RECEIVED), (B, -61, RECEIVED)]),
    ("rf_msgs node", "rf_msgs/WifiNodeData", "string macaddress\nfloat32 strength\n",
     {"macaddress": A, "strength": -50.5}, [(A, -50.5, RECEIVED)]),
    ("wiros packet", "rf_msgs/Wifi", WIFI_CSI + HEADER,  # the address as bytes
     {"header": STAMP, "txmac": BYTES_A, "rssi": -50, "csi_real": [0.5] * 234,
      "csi_imag": [0.5] * 234}, [(A, -50, STAMPED)]),
    ("wiros list", "rf_msgs/AccessPoints",  # stations without a stamp of their own
     "#A list of stations.\n\nstd_msgs/Header header\nStation[] aps\n" + HEADER +
     part("rf_msgs/Station", STATION),
     {"header": STAMP, "aps": [{"mac": BYTES_A, "rssi": -50},
                               {"mac": BYTES_B, "rssi": -61,
                                "header": {"stamp": {"secs": 999, "nsecs": 0}}}]},
     [(A, -50, STAMPED), (B, -61, 999.0)]),
    ("isaac", "isaac_hw_msgs/WifiSignals",
     "WifiSignal[] signals\n" + part("isaac_hw_msgs/WifiSignal",
                                     "Header header\nstring ssid\nstring bssid\n"
                                     "float32 signal_dbm") + HEADER,
     {"signals": [{"header": STAMP, "ssid": "a", "bssid": A, "signal_dbm": -50.0}]},
     [(A, -50, STAMPED)]),
    ("state with ages", "wifi_localization/WifiState",
     "Header header\nstring[] ssids\nstring[] macs\nuint16[] channels\nint16[] strengths\n"
     "int32[] ms\nbool[] changed_signal_strength\n" + HEADER,
     {"header": STAMP, "ssids": ["a", "b"], "macs": [A, B], "channels": [1, 6],
      "strengths": [-50, -61], "ms": [0, 1250], "changed_signal_strength": [True, False]},
     [(A, -50, STAMPED), (B, -61, 999.0)]),
    ("state with flags", "wifi_localization/WifiState",
     "Header header\nstring[] ssids\nstring[] macs\nuint8[] channels\nint16[] strengths\n"
     "int16[] noise\nbool[] changed_signal_strength\n" + HEADER,
     {"header": STAMP, "ssids": ["a", "b"], "macs": [A, B], "channels": [1, 6],
      "strengths": [-50, -61], "noise": [-90, -90], "changed_signal_strength": [True, False]},
     [(A, -50, STAMPED), "1 the driver marks readings as old"]),
    ("fingerprint", "wifi_scan/Fingerprint", "Header header\n\nAddressRSSI[] list\n" + HEADER +
     part("wifi_scan/AddressRSSI", "string address\nfloat64 rssi"),
     {"header": STAMP, "list": [{"address": A, "rssi": -50.25}]}, [(A, -50.25, STAMPED)]),
    ("rssi", "wifi_scan/RSSI", "Header header\n\nstring address\nint32 rssi\n" + HEADER,
     {"header": STAMP, "address": A, "rssi": -50}, [(A, -50, STAMPED)]),
    sign_lost("hot spots", "wifi_localization/WifiData", "Wifi[] HotSpots\nuint32 length",
              {"HotSpots": [{"MAC": A, "dB": 50}, {"MAC": B, "dB": 61}], "length": 2},
              "string MAC\nstring essid\nuint32 dB"),
    sign_lost("hot spots by address", "wifi_localization/WifiData", "Wifi[] HotSpots\nuint32 length",
              {"HotSpots": [{"address": A, "signal": 50}, {"address": B, "signal": 61}]},
              "string address\nstring essid\nuint32 signal"),
    sign_lost("hot spots as text", "wifi_lookup/WifiData", "Wifi[] HotSpots",
              {"HotSpots": [{"MAC": A, "dB": "-50"}, {"MAC": B, "dB": "61"}]},
              "string MAC\nstring dB"),
    ("one hot spot", "wifi_publisher/wifi", "string MAC\nuint32 dB\nstring ssid\n",
     {"MAC": A, "dB": 50, "ssid": "a"}, [(A, -50, RECEIVED)]),
    ("wifi_tools", "wifi_tools/WifiData", "Header header\nAccessPoint[] data\n" + HEADER +
     part("wifi_tools/AccessPoint", "string mac_address\nint16 ss\nint16 noise"),
     {"header": STAMP, "data": [{"mac_address": A, "ss": -50, "noise": -90}]}, [(A, -50, STAMPED)]),
    ("monitor mode", "wifi_sensor/RssiMulti", "Header header\nRssi[] data\n" + HEADER +
     part("wifi_sensor/Rssi", "Header header\nstring my_mac_addr\nstring their_mac_addr\n"
                              "float32[] rssi"),
     {"header": STAMP, "data": [{"header": STAMP, "their_mac_addr": A, "rssi": [-48.0, -52.0]},
                                {"header": STAMP, "their_mac_addr": B, "rssi": []}]},
     [(A, -50, STAMPED), "1 a signal strength is 0 or missing"]),
    ("measurement", "wifi_scanner/WifiMeasurement",
     "string ssid\nstring bssid\nfloat32 rssi\ntime stamp\n",
     {"bssid": A, "rssi": -50.0, "stamp": {"secs": 1000, "nsecs": 250000000}}, [(A, -50, STAMPED)]),
    ("scan of ROS 2", "wifi_scanner/WifiScan",  # as a converted bag has it
     "builtin_interfaces/Time stamp\nstring[] ssid\nstring[] bssid\nint32[]  power\n" +
     part("builtin_interfaces/Time", "int32 sec\nuint32 nanosec"),
     {"stamp": {"sec": 1000, "nanosec": 250000000}, "bssid": [A, B], "power": [-50, -61]},
     [(A, -50, STAMPED), (B, -61, STAMPED)]),
    ("one of a scan", "wifi_localization/WifiScan", "int64 strength\nstring mac_address\n",
     {"strength": -50, "mac_address": A}, [(A, -50, RECEIVED)]),
    ("smd", "smd_wifi_monitor/WifiStatus", "Header header\nWifiDeviceInfo[] devices\n" + HEADER +
     part("smd_wifi_monitor/WifiDeviceInfo",
          "string name\nstring mac\nstring mode\nstring essid\nstring state\nuint32 frequency\n"
          "WifiStationInfo[] stations") + part("smd_wifi_monitor/WifiStationInfo", STATION_INFO),
     {"header": STAMP, "devices": [{"name": "wlan0", "stations": []},
                                   {"name": "wlan1", "stations": [{"bssid": A, "signal": -50}]}]},
     [(A, -50, STAMPED)]),
    ("cabot", "std_msgs/String", "string data\n",
     {"data": cabot({"type": "WiFi", "mac": A, "rssi": -50.0, "frequency_GHz": 2.437,
                     "last_seen_ms": 250},
                    {"type": "iBeacon", "mac": B, "rssi": -61})},
     [(A, -50, 1000.0)]),
    ("cabot on esp32", "std_msgs/String", "string data\n",
     {"data": cabot({"type": "WiFi", "mac": A, "rssi": -50, "channel": "6", "timestamp": 999.5})},
     [(A, -50, 999.5)]),
    ("iw", "std_msgs/String", "string data\n", {"data": IW}, [
        (A, -50, 1000.25), (B, -61.5, 1000.5), "1 a signal strength is 0 or missing"]),
    ("iwlist", "std_msgs/String", "string data\n", {"data": IWLIST}, [
        (A, -50, 1000.25), (B, -61, RECEIVED), "1 a signal strength is 0 or missing"]),
    ("esp32", "std_msgs/String", "string data\n",
     {"data": A.upper() + ",a, b,1,-50,1000,250000000"}, [(A, -50, STAMPED)]),
    ("wifiscanner", "diagnostic_msgs/DiagnosticArray", DIAGNOSTICS,
     {"header": STAMP, "status": [keys(cell="01", bssid=A, channel="6", quality="60", signal="-50"),
                                  keys(cell="02", bssid=B, signal="-61")]},
     [(A, -50, STAMPED), (B, -61, STAMPED)]),
    ("wifiscanner link", "diagnostic_msgs/DiagnosticArray", DIAGNOSTICS,
     {"header": STAMP, "status": [keys(ap_hwaddr=A, freq="2.437 GHz", signal_level="-50 dBm")]},
     [(A, -50, STAMPED)]),

    # Nothing can be taken from these.
    ("diagnostics", "diagnostic_msgs/DiagnosticArray", DIAGNOSTICS,
     {"header": STAMP, "status": [keys(temperature="40")]},
     ["1 its messages are of type diagnostic_msgs/DiagnosticArray, and none of its statuses has"]),
    ("no line of an esp32", "std_msgs/String", "string data\n", {"data": A + ",-50,1000,0"},
     ["1 its messages are of type std_msgs/String, and its text is no JSON object and no output of"]),
    ("link of nothing", "wireless_msgs/Connection",
     "float32 bitrate\nint16 txpower\nstring link_quality_raw\nfloat32 link_quality\n"
     "int16 signal_level\nint16 noise_level\nstring essid\nstring bssid\nfloat64 frequency\n",
     {"bssid": A}, ["0 the radio is not associated"]),
    ("no strength", "wireless_msgs/Network",
     "string type\nstring essid\nstring mac\nstring mode\nstring frequency\nbool encryption\n",
     {"mac": A}, ["1 its messages are of type wireless_msgs/Network, which tell no signal"]),
    ("no address", "rtabmap_ros/EnvSensor", "std_msgs/Header header\nint32 type\nfloat64 value\n" +
     HEADER, {"header": STAMP, "type": 1, "value": -50.0},
     ["1 its messages are of type rtabmap_ros/EnvSensor, which name no access point"]),
    ("plain text", "std_msgs/String", "string data\n", {"data": "-50 dBm"},
     ["1 its messages are of type std_msgs/String, and its text is no JSON object"]),
    ("other text", "std_msgs/String", "string data\n", {"data": '{"bssid": "%s"}' % A},
     ["1 its messages are of type std_msgs/String, and its JSON has no list 'data'"]),
    ("unknown", "geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n", {"x": 1.0},
     ["1 its messages are of type geometry_msgs/Point, which is unknown; describe it"]),
    ("namesake", "rf_msgs/Wifi", "string name\n", {"name": "a"},
     ["1 its messages are of type rf_msgs/Wifi, which has no field txmac"]),
    ("bad addresses", "rf_msgs/Wifi", WIFI_CSI + HEADER,
     {"header": STAMP, "txmac": BYTES_A[:5], "rssi": -50}, ["1 a BSSID is malformed"]),
    ("no time", "structure_from_wifi/WifiScan",
     "Header header\nApReading[] readings\n" + HEADER +
     part("structure_from_wifi/ApReading",
          "string bssid\nstring ssid\nfloat32 rssi_dbm\nfloat32 frequency_mhz\nfloat32 age_s"),
     {"readings": [{"bssid": A, "rssi_dbm": -50.0, "age_s": -1.0},
                   {"bssid": A, "rssi_dbm": 0.0}]},
     [(A, 0, RECEIVED), "1 a reading has no usable time or age"]),
]

# md5 sums that other sources name, so the definitions above are the real ones.
MD5 = {"link": "f1a0d060cec0bda21949621526aa056e", "link of pr2": "810217d9e35df31ffb396ea5673d7d1b",
       "survey of wifi_ddwrt": "f1063b16bb121ef190ae5edfe09d94ec"}

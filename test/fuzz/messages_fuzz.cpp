// Messages of every input, with fields of any content, and their way to readings.

#include <sensor_msgs/point_cloud2_iterator.h>
#include <structure_from_wifi/WifiScan.h>
#include <wireless_msgs/Connection.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fuzz_target.h"
#include "ros/any_message_of.h"
#include "ros/conversion/input_messages.h"
#include "ros/mapping/localization.h"

namespace sfw::fuzz {
namespace {

/// Takes fields from the front of an input; zeros and nothing after its end.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  Number number() {
    Number number{};
    const std::string_view bytes = next(sizeof number);
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
  }

  std::string text() { return std::string(next(number<std::uint8_t>())); }

  std::string_view next(std::size_t size) {
    const std::string_view front = bytes_.substr(0, size);
    bytes_.remove_prefix(front.size());
    return front;
  }

  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

ros::Time timeOf(Fields& fields) {
  constexpr std::uint32_t kSecond = 1'000'000'000;
  const auto seconds = fields.number<std::uint32_t>();
  return {seconds, fields.number<std::uint32_t>() % kSecond};
}

void fill(structure_from_wifi::WifiScan& scan, Fields& fields) {
  scan.header.stamp = timeOf(fields);
  scan.header.frame_id = fields.text();
  while (!fields.rest().empty()) {
    structure_from_wifi::ApReading reading;
    reading.bssid = fields.text();
    reading.ssid = fields.text();
    reading.rssi_dbm = fields.number<float>();
    reading.frequency_mhz = fields.number<float>();
    reading.age_s = fields.number<float>();
    scan.readings.push_back(reading);
  }
}

void fill(wireless_msgs::Connection& connection, Fields& fields) {
  connection.bssid = fields.text();
  connection.essid = fields.text();
  connection.signal_level = fields.number<std::int16_t>();
  connection.frequency = fields.number<double>();
}

void fill(std_msgs::Bool& contact, Fields& fields) { contact.data = fields.number<std::uint8_t>(); }

void fill(sensor_msgs::PointCloud2& cloud, Fields& fields) {
  cloud.header.stamp = timeOf(fields);
  cloud.header.frame_id = fields.text();
  cloud.height = fields.number<std::uint32_t>();
  cloud.width = fields.number<std::uint32_t>();
  cloud.is_bigendian = fields.number<std::uint8_t>();
  cloud.point_step = fields.number<std::uint32_t>();
  cloud.row_step = fields.number<std::uint32_t>();
  cloud.fields.resize(fields.number<std::uint8_t>() % 8);
  for (sensor_msgs::PointField& field : cloud.fields) {
    field.name = fields.text();
    field.offset = fields.number<std::uint32_t>();
    field.datatype = fields.number<std::uint8_t>();
    field.count = fields.number<std::uint32_t>();
  }
  cloud.data.assign(fields.rest().begin(), fields.rest().end());
}

const InputContext kContext{ros::Time(5.0), "base_link", 0.15};

template <class Message>
Conversion converted(std::string_view topic, Fields& fields) {
  Message message;
  fill(message, fields);
  const auto* input = std::find_if(kInputs.begin(), kInputs.end(),
                                   [&](const Input& known) { return known.topic == topic; });
  require(input != kInputs.end());
  return input->convert(anyMessageOf(message), kContext);
}

/// A message of any definition and bytes, of a type that is known or not.
AnyMessage anyMessage(Fields& fields) {
  AnyMessage message;
  message.type = fields.text();
  message.definition = fields.next(fields.number<std::uint16_t>());
  message.bytes.assign(fields.rest().begin(), fields.rest().end());
  return message;
}

void check(const Conversion& conversion, const tf2::BufferCore& transforms) {
  for (const Observation& observation : conversion.observations) {
    std::string tf_error;
    locate(observation, {}, transforms, tf_error);
    if (const auto* contacts = std::get_if<UnlocatedContacts>(&observation.content)) {
      for (const Eigen::Vector3d& point : contacts->points) {
        require(point.allFinite());
      }
    }
  }
}

/// A transform that is always there.
void fill(tf2::BufferCore& transforms) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "base_link";
  transform.transform.rotation.w = 1.0;
  transforms.setTransform(transform, "fuzz", true);
}

std::string bytesOf(const std::vector<std::string>& fields) {
  std::string bytes;
  for (const std::string& field : fields) {
    bytes += field;
  }
  return bytes;
}

std::string textField(const std::string& text) { return static_cast<char>(text.size()) + text; }

template <class Number>
std::string numberField(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string cloudSeed() {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier(cloud).setPointCloud2FieldsByString(1, "xyz");
  sensor_msgs::PointCloud2Modifier(cloud).resize(2);
  std::vector<std::string> fields{
      numberField<std::uint32_t>(5), numberField<std::uint32_t>(0), textField("base_link"),
      numberField(cloud.height),     numberField(cloud.width),      std::string(1, '\0'),
      numberField(cloud.point_step), numberField(cloud.row_step),   std::string(1, '\3')};
  for (const sensor_msgs::PointField& field : cloud.fields) {
    fields.insert(fields.end(), {textField(field.name), numberField(field.offset),
                                 numberField(field.datatype), numberField(field.count)});
  }
  fields.emplace_back(cloud.data.begin(), cloud.data.end());
  return bytesOf(fields);
}

std::string messageSeed(const std::string& type, const std::string& definition,
                        const std::string& bytes) {
  return '\4' +
         bytesOf({textField(type), numberField(static_cast<std::uint16_t>(definition.size())),
                  definition, bytes});
}

/// A text as messages hold it.
std::string serialized(const std::string& text) {
  return numberField(static_cast<std::uint32_t>(text.size())) + text;
}

std::string textSeed(const std::string& text) {
  return messageSeed("std_msgs/String", "string data\n", serialized(text));
}

std::string diagnosticsSeed() {
  const std::uint32_t one = 1;
  return messageSeed(
      "diagnostic_msgs/DiagnosticArray",
      "Status[] status\n===\nMSG: diagnostic_msgs/Status\nKeyValue[] values\n===\n"
      "MSG: diagnostic_msgs/KeyValue\nstring key\nstring value\n",
      numberField(one) + numberField(one) + serialized("bssid") + serialized("02:00:00:00:00:01"));
}

}  // namespace

std::vector<std::string> seeds() {
  const std::string reading =
      bytesOf({textField("02:00:00:00:00:01"), textField("home"), numberField(-50.0F),
               numberField(2437.0F), numberField(0.25F)});
  return {
      '\0' + bytesOf({numberField<std::uint32_t>(5), numberField<std::uint32_t>(0),
                      textField("base_link"), reading, reading}),
      '\1' + bytesOf({textField("02:00:00:00:00:01"), textField("home"),
                      numberField<std::int16_t>(-50), numberField(2.437)}),
      '\2' + std::string(1, '\1'),
      '\3' + cloudSeed(),
      messageSeed("rf_msgs/Station", "uint8[6] mac\nint32 rssi # a\n",
                  std::string("\2\0\0\0\0\1", 6) + numberField<std::int32_t>(-50)),
      textSeed(R"({"data": [{"mac": "02:00:00:00:00:01", "rssi": -50, "last_seen_ms": 5}]})"),
      textSeed("BSS 02:00:00:00:00:01(on wlan0)\n\tsignal: -50.00 dBm\n\tlast seen: 5 ms ago\n"),
      textSeed("02:00:00:00:00:01,a,b,1,-50,1000,5"),
      diagnosticsSeed(),
  };
}

void feed(std::string_view input) {
  if (input.empty()) {
    return;
  }
  static tf2::BufferCore transforms;
  static const bool filled = (fill(transforms), true);
  require(filled);
  Fields fields(input.substr(1));
  switch (static_cast<unsigned char>(input.front()) % 5) {
    case 0:
      return check(converted<structure_from_wifi::WifiScan>("wifi_scan", fields), transforms);
    case 1:
      return check(converted<wireless_msgs::Connection>("connection", fields), transforms);
    case 2:
      return check(converted<std_msgs::Bool>("contact", fields), transforms);
    case 3:
      return check(converted<sensor_msgs::PointCloud2>("contact_points", fields), transforms);
    default:
      return check(convertReadings(anyMessage(fields), kContext), transforms);
  }
}

}  // namespace sfw::fuzz

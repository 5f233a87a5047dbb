#include "ros/rviz/mapping_panel.h"

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <structure_from_wifi/SaveMap.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <chrono>
#include <utility>

#include "ros/service_call.h"

namespace sfw {
namespace {

double steadyS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

const char* colourOf(int level) {
  switch (level) {
    case diagnostic_msgs::DiagnosticStatus::OK:
      return "#1b7a2f";
    case diagnostic_msgs::DiagnosticStatus::WARN:
      return "#b05a00";
    default:
      return "#b00020";
  }
}

/// What the panel shows of the diagnostics, in this order: key and title.
constexpr std::pair<const char*, const char*> kFigures[] = {
    {"readings", "readings"},
    {"access points heard", "access points heard"},
    {"access points of the table", "of the table"},
    {"unknown access points", "unknown ones"},
    {"free area", "free area"},
    {"inference time", "time of an update"}};

std::string messageOf(const std_srvs::Trigger::Response& response) { return response.message; }
std::string messageOf(const std_srvs::SetBool::Response& response) { return response.message; }
std::string messageOf(const structure_from_wifi::SaveMap::Response& response) {
  return (response.success != 0 ? "Saved: " : "Not saved: ") + response.message;
}

QLabel* addLabel(QVBoxLayout* layout, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(label);
  return label;
}

/// A place for texts that scrolls in a low dock, where a layout alone would cut them.
QVBoxLayout* addScrolledTexts(QVBoxLayout* layout) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  layout->addWidget(area, 1);
  auto* content = new QWidget;
  area->setWidget(content);
  auto* texts = new QVBoxLayout(content);
  texts->setContentsMargins(0, 0, 0, 0);
  return texts;
}

QPushButton* addButton(QHBoxLayout* layout, const char* text, const char* tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(text);
  button->setToolTip(tip);
  layout->addWidget(button);
  return button;
}

}  // namespace

MappingPanel::MappingPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* layout = new QVBoxLayout(this);  // owns all widgets
  auto* top = new QHBoxLayout;
  top->addWidget(new QLabel("Node"));
  nodes_ = new QComboBox;
  nodes_->setObjectName("Node");
  top->addWidget(nodes_, 1);
  layout->addLayout(top);
  QVBoxLayout* texts = addScrolledTexts(layout);
  reports_ = addLabel(texts, "Reports");
  figures_ = addLabel(texts, "Figures");
  texts->addStretch();
  auto* saving = new QHBoxLayout;
  directory_ = new QLineEdit("map");
  directory_->setObjectName("Directory");
  directory_->setToolTip("Name of the directory inside ros/save_directory");
  saving->addWidget(directory_, 1);
  save_ = addButton(saving, "Save", "Write the map and the recording into this directory");
  layout->addLayout(saving);
  auto* buttons = new QHBoxLayout;
  pause_ = addButton(buttons, "Pause", "Drop readings while this is pressed");
  pause_->setCheckable(true);
  reset_ = addButton(buttons, "Reset", "Forget all readings, and begin a new map");
  layout->addLayout(buttons);
  message_ = addLabel(layout, "Message");

  connect(save_, &QPushButton::clicked, this, [this] {
    structure_from_wifi::SaveMap request;
    request.request.directory = directory_->text().toStdString();
    call("save_map", request);
  });
  connect(pause_, &QPushButton::clicked, this, [this](bool pressed) {
    std_srvs::SetBool request;
    request.request.data = pressed;
    call("pause", request);
  });
  connect(reset_, &QPushButton::clicked, this, [this] { call("reset", std_srvs::Trigger()); });
  connect(nodes_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    Q_EMIT configChanged();
    refresh();
  });
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this] { refresh(); });
  constexpr int kRefreshMs = 300;
  timer->start(kRefreshMs);
  subscriber_ = ros_.subscribe("/diagnostics", 10, &MappingPanel::receive, this);
  refresh();
}

MappingPanel::~MappingPanel() = default;

void MappingPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Node", &text)) {
    chosen_ = text.toStdString();
  }
  if (config.mapGetString("Directory", &text)) {
    directory_->setText(text);
  }
}

void MappingPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", QString::fromStdString(node()));
  config.mapSetValue("Directory", directory_->text());
}

void MappingPanel::receive(const diagnostic_msgs::DiagnosticArray& diagnostics) {
  status_.insert(diagnostics, steadyS());
  for (const std::string& name : status_.nodes()) {
    const QString text = QString::fromStdString(name);
    if (nodes_->findText(text) < 0) {
      nodes_->addItem(text);
      if (name == chosen_) {
        nodes_->setCurrentText(text);
      }
    }
  }
}

void MappingPanel::refresh() {
  QString text;
  for (const MapperStatus::Report& report : status_.reports(node(), steadyS())) {
    text += QString("<p style='color:%1; margin:2px'>%2</p>")
                .arg(colourOf(report.level), QString::fromStdString(report.text).toHtmlEscaped());
  }
  reports_->setText(text);
  showFigures();
  const bool is_busy =
      answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  if (answer_.valid() && !is_busy) {
    say(answer_.get());
  }
  for (QPushButton* button : {save_, pause_, reset_}) {
    button->setEnabled(!is_busy && !node().empty());
  }
  if (const auto paused = status_.value(node(), "paused"); paused && !is_busy) {
    pause_->setChecked(*paused == "True");
  }
}

void MappingPanel::showFigures() {
  QString rows;
  for (const auto& [key, title] : kFigures) {
    if (const auto value = status_.value(node(), key)) {
      rows += QString("<tr><td>%1&nbsp;&nbsp;</td><td><b>%2</b></td></tr>")
                  .arg(title, QString::fromStdString(*value).toHtmlEscaped());
    }
  }
  figures_->setText("<table>" + rows + "</table>");
}

std::string MappingPanel::node() const { return nodes_->currentText().toStdString(); }

std::string MappingPanel::service(const std::string& name) const {
  return "/" + node() + "/" + name;
}

template <class Service>
void MappingPanel::call(const std::string& name, const Service& request) {
  say("Waiting for " + service(name) + " ...");
  answer_ = std::async(std::launch::async, [name = service(name), call = request]() mutable {
    if (!ros::service::exists(name, false)) {
      return name + " does not exist: look whether the node runs.";
    }
    return callService(name, call) ? messageOf(call.response)
                                   : name + " failed: see the log of the node.";
  });
  refresh();
}

void MappingPanel::say(const std::string& text) { message_->setText(QString::fromStdString(text)); }

}  // namespace sfw

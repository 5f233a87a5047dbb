#pragma once

namespace sfw {

/// Whether a map uses signal strengths. Without them it is an ablation.
enum class UseRadio { kNo, kYes };

}  // namespace sfw

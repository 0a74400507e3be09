#pragma once

namespace esm {

inline constexpr double pi = 3.14159265358979323846;

constexpr double toRadians(double degrees) {
    return degrees * pi / 180;
}

constexpr double toDegrees(double radians) {
    return radians * (180 / pi);
}

} // namespace esm

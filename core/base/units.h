#pragma once
// Core is SI (m, kg, s, radians). Other units exist at the borders only: pattern files (mm),
// fabric cards (g/m²), people (degrees).

namespace toile {

inline constexpr double kPi = 3.14159265358979323846;

constexpr double metres_from_mm(double mm) { return mm * 1e-3; }
constexpr double mm_from_metres(double m) { return m * 1e3; }
constexpr double radians_from_degrees(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees_from_radians(double radians) { return radians * (180 / kPi); }

}  // namespace toile

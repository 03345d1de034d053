#pragma once
/// A few doubles at once, for the kernels of the multifrontal solver: Eigen's packets by plain names. They multiply and
/// add in one rounding where the processor can, whatever the compiler is told about contraction.

#include <Eigen/Core>

#include "lissom/core/multifrontal_kernels.h"

namespace lissom::multifrontal {

using Packet = Eigen::internal::find_best_packet<double, kPad>::type;
constexpr int kLanes = Eigen::internal::unpacket_traits<Packet>::size;
static_assert(kPad % kLanes == 0);

inline Packet load(const double* x) { return Eigen::internal::ploadu<Packet>(x); }
inline void store(double* x, Packet p) { Eigen::internal::pstoreu(x, p); }
inline Packet all(double x) { return Eigen::internal::pset1<Packet>(x); }
inline Packet add(Packet a, Packet b) { return Eigen::internal::padd(a, b); }
inline Packet subtract(Packet a, Packet b) { return Eigen::internal::psub(a, b); }
inline Packet negative(Packet a) { return Eigen::internal::pnegate(a); }
inline Packet multiply(Packet a, Packet b) { return Eigen::internal::pmul(a, b); }
inline Packet multiply_add(Packet a, Packet b, Packet c) { return Eigen::internal::pmadd(a, b, c); }
inline double sum(Packet a) { return Eigen::internal::predux(a); }

}  // namespace lissom::multifrontal

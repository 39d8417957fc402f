#include "build_impl.hpp"

namespace carom {

template World<double, 1> build<double, 1>(const Scene&);
template World<double, 2> build<double, 2>(const Scene&);
template World<double, 3> build<double, 3>(const Scene&);
template WorldAndGases<1> build_apart<1>(const Scene&);
template WorldAndGases<2> build_apart<2>(const Scene&);
template WorldAndGases<3> build_apart<3>(const Scene&);
template World<double, 1> join<1>(WorldAndGases<1>);
template World<double, 2> join<2>(WorldAndGases<2>);
template World<double, 3> join<3>(WorldAndGases<3>);
template Time<double> clock_time<double>(const Number&, int);

}  // namespace carom

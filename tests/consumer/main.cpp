// Uses what an installed carom gives: a header-only type and a function of the library.

#include <carom/core/error.hpp>
#include <carom/scene/scene.hpp>

#include <iostream>

int main() {
  carom::Scene scene;
  scene.title = "consumer";
  scene.balls.emplace_back().radius = 0.25;

  const carom::InputError error({"consumer.toml", 3, "ball 0 is alone", "", "Add a ball?"});
  std::cout << error.what() << '\n';

  const bool as_expected = scene.dimension == 2 && scene.balls[0].radius == 0.25 &&
                           std::string(error.what()) == "consumer.toml:3: ball 0 is alone. Add a ball?";
  return as_expected ? 0 : 1;
}

#pragma once
// What the module with MPI in it offers, as plain functions.

#include <cstddef>

extern "C" {

struct CaromRanks {
  int (*rank)();
  int (*size)();
  void (*send)(int to, const char* text, std::size_t size);
  bool (*poll)(int* from, std::size_t* size);  ///< whether a letter is there, from whom, and how long
  void (*take)(int from, char* text, std::size_t size);
  void (*end)();
  void (*abort)();
};

/// Begins MPI. False: it does not start.
using CaromRanksBegin = bool (*)(CaromRanks*);
}

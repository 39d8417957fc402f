// carom_mpi.so: the processes that mpirun has started, by MPI. Loaded by ranks.cpp.

#include "ranks_module.hpp"

#include <mpi.h>

namespace {

constexpr int letters = 0;  // the one tag

int rank() {
  int r = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &r);
  return r;
}

int size() {
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

void send(int to, const char* text, std::size_t length) {
  MPI_Send(text, static_cast<int>(length), MPI_CHAR, to, letters, MPI_COMM_WORLD);
}

bool poll(int* from, std::size_t* length) {
  int there = 0, count = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, letters, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return false;
  MPI_Get_count(&status, MPI_CHAR, &count);
  *from = status.MPI_SOURCE;
  *length = static_cast<std::size_t>(count);
  return true;
}

void take(int from, char* text, std::size_t length) {
  MPI_Recv(text, static_cast<int>(length), MPI_CHAR, from, letters, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

void end() { MPI_Finalize(); }
void abort_all() { MPI_Abort(MPI_COMM_WORLD, 1); }

}  // namespace

extern "C" bool carom_ranks_begin(CaromRanks* ranks) {
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS) return false;
  *ranks = {rank, size, send, poll, take, end, abort_all};
  return provided >= MPI_THREAD_SERIALIZED;
}

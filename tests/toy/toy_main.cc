// A program with the toy system alone, as a user's own project would have it.
#include "sim/app/program.h"
#include "toy/toy_system.h"

int main(int argc, char** argv) {
  return dockyard::RunProgram(argc, argv, {dockyard::toy::ToySystem()});
}

// A program with the diver alone.
#include "sim/app/program.h"
#include "toy_underwater/diver_system.h"

int main(int argc, char** argv) {
  return dockyard::RunProgram(argc, argv, {dockyard::diver::DiverSystem()});
}

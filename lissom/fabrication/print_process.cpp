#include "lissom/fabrication/print_process.h"

#include <vector>

namespace lissom {

std::span<const PrintProcess> print_processes() {
  static const std::vector<PrintProcess> processes{
      {"sls", "selective laser sintering of nylon powder", 1e-3, 0.5e-3, Vec3(0.19, 0.24, 0.3), 100,
       "diameter: structural minimum of service guides for PA12 (Layer X, i.am.rapid: 1 mm); gap: 0.5 mm for moving "
       "parts "
       "(i.am.rapid, Ermax); bed: EOS Formiga P110 as exaparts offers it, 190 x 240 x 300 mm; cost: an estimate of 50 "
       "to 100 "
       "euro per kg of PA12 with as much again refreshed, override it"},
      {"fdm", "fused deposition, 0.4 mm nozzle", 0.8e-3, 0.5e-3, Vec3(0.25, 0.21, 0.21), 32,
       "diameter: two lines of a 0.4 mm nozzle (Neway, PrintPal guides: 0.8 mm); gap: clearance in fabb-it's guide, "
       "0.5 mm; "
       "bed: Original Prusa MK3S in PrusaSlicer's profiles, 250 x 210 x 210 mm; cost: 0.032 euro per g of PLA (LUCA "
       "School of "
       "Arts, formlab price list 2023; its TPU: 0.085)"},
      {"sla", "stereolithography of resin", 0.6e-3, 0.5e-3, Vec3(0.145, 0.145, 0.185), 150,
       "diameter: unsupported wall in addema's guide, 0.6 mm; gap: clearance there, 0.5 mm; bed: Formlabs Form 3 by "
       "its data "
       "sheet, 145 x 145 x 185 mm; cost: an estimate for standard resin, override it"},
  };
  return processes;
}

const PrintProcess* find_process(std::string_view name) {
  for (const PrintProcess& process : print_processes()) {
    if (process.name == name) return &process;
  }
  return nullptr;
}

}  // namespace lissom

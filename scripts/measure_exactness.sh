#!/usr/bin/env bash
# The truth that docs/exactness.md holds the simulator against: hardware counters of every launch of tests/exactness/,
# its PTX and what ptxas makes of it.
#
#   scripts/measure_exactness.sh export LAUNCHES [WARPGRAIN]       on a machine with clang: launches as files
#   scripts/measure_exactness.sh run LAUNCHES OUT [WARPGRAIN]      on one with an NVIDIA GPU, ncu and ptxas: counts them
#
# WARPGRAIN: the program, build/release/cli/warpgrain when left out. `run` needs no network and changes no setting of the
# device. A launch that fails is named at the end and stops nothing; after SECONDS_LIMIT seconds no other one begins. What is counted is the cubin whose listing is kept;
# the code that the driver assembles itself is counted as well, for the record of where both differ.
#
# OUT holds exactness.tar.xz, with a folder a kind: launches (the .sim and .ptx), code (cubin and listing), counters (ncu's raw
# page), driver_counters, instructions (ncu's counts of each machine instruction), times (warpgrain measure --json).
set -uo pipefail
cd "$(dirname "$0")/.." || exit

variants=(branchy/cells/cell/fp32/default simple/cells/cell/fp32/default branchless/cells/cell/fp32/default
  sfu_minimised/cells/cell/fp32/default branchy/cells/unsorted/fp32/default
  branchy/cells/cell/fp64/default)

export_launches() {
  local launches=$1 warpgrain=$2 launch variant folder
  mkdir -p "$launches"
  for launch in tests/exactness/kernels/*.sim; do
    "$warpgrain" profile "$launch" --unchecked --quiet --json "$launches/.report.json" --export "$launches" >/dev/null ||
      echo "export: $launch failed" >&2
  done
  for variant in "${variants[@]}"; do
    folder=$launches/${variant//\//-}
    "$warpgrain" profile --scene tests/exactness/scenes/dense_bed.json --variant "$variant" --model full --unchecked --quiet \
      --json "$launches/.report.json" --export "$folder" || echo "export: $variant failed" >&2
  done
  # Of the kernels that no variant changes one copy is enough.
  for folder in "$launches"/*/; do
    [[ $folder == */"${variants[0]//\//-}"/ ]] && continue
    for launch in "$folder"*.sim; do
      [[ $(basename "$launch") == force* ]] || rm -f "${launch%.sim}".*
    done
  done
  rm -f "$launches"/.report*
}

metrics=$(tr '\n' , <<'END'
smsp__inst_executed.sum
smsp__thread_inst_executed.sum
smsp__thread_inst_executed_pred_on.sum
smsp__sass_branch_targets.sum
smsp__sass_branch_targets_threads_divergent.sum
smsp__sass_branch_targets_threads_uniform.sum
smsp__inst_executed_pipe_xu.sum
l1tex__t_requests_pipe_lsu_mem_global_op_ld.sum
l1tex__t_requests_pipe_lsu_mem_global_op_st.sum
l1tex__t_sectors_pipe_lsu_mem_global_op_ld.sum
l1tex__t_sectors_pipe_lsu_mem_global_op_st.sum
l1tex__t_requests_pipe_lsu_mem_global_op_red.sum
l1tex__t_requests_pipe_lsu_mem_global_op_atom.sum
l1tex__t_requests_pipe_lsu_mem_local_op_ld.sum
l1tex__t_requests_pipe_lsu_mem_local_op_st.sum
smsp__inst_executed_op_shared_ld.sum
smsp__inst_executed_op_shared_st.sum
launch__registers_per_thread
gpu__time_duration.sum
END
)
metrics=${metrics%,}

run_launches() {
  local launches out=$2 warpgrain=$3 limit=${SECONDS_LIMIT:-100000} launch name work failed=()
  launches=$(realpath "$1")
  work=$(mktemp -d)
  mkdir -p "$out" "$work"/{launches,code,reports,driver_reports,counters,driver_counters,instructions,times,logs}
  {
    nvidia-smi -q | grep -E "Product Name|Driver Version|CUDA Version" | head -3
    ncu --version | tail -2
    "$(command -v ptxas || echo /usr/local/cuda/bin/ptxas)" --version | tail -2
    "$warpgrain" --version
    date -u +%F
  } >"$work/machine.txt" 2>&1
  without_dumps() { sed '/^  .*\[[0-9]*\] = /d'; }
  # Counts the launch itself, and none of warpgrain's own small kernels beside it.
  count() { # REPORT ASSEMBLER NCU-OPTIONS...
    local report=$1 assembler=$2
    shift 2
    ncu --clock-control none --target-processes all --profile-from-start off "$@" -f -o "$report" \
      "$warpgrain" measure "$launch" --assembler "$assembler" --mark --repeats 1 --warm-up 0 --quiet 2>&1 |
      without_dumps >>"$work/logs/$name.txt"
  }
  while read -r launch; do
    name=${launch#"$launches"/}
    name=${name%.sim}
    name=${name//\//-}
    if ((SECONDS > limit)); then
      failed+=("$name: not run, out of time")
      continue
    fi
    cp "$launch" "$work/launches/$name.sim"
    if ! "$warpgrain" measure "$launch" --assembler ptxas --keep "$work/kept" --check --repeats 10 --quiet \
      --json "$work/times/$name.json" 2>&1 | without_dumps >"$work/logs/$name.txt"; then
      failed+=("$name: measure, or the buffers' contents")
      head -3 "$work/logs/$name.txt"
    fi
    mv "$work/kept/$(basename "${launch%.sim}").cubin" "$work/code/$name.cubin"
    mv "$work/kept/$(basename "${launch%.sim}").ptx" "$work/launches/$name.ptx"
    count "$work/reports/$name" ptxas --section SourceCounters --metrics "$metrics" || failed+=("$name: counters")
    count "$work/driver_reports/$name" driver \
      --metrics smsp__inst_executed.sum,smsp__thread_inst_executed.sum || failed+=("$name: counters of the driver's code")
    echo "$name at $SECONDS s"
  done < <(find "$launches" -name '*.sim' | sort)
  (
    cd "$work" || exit
    # shellcheck disable=SC2317 # called below, by xargs
    list() { nvdisasm -c -hex "code/$1.cubin" >"code/$1.sass" || cuobjdump -sass "code/$1.cubin" >"code/$1.sass"; }
    # shellcheck disable=SC2317
    page() { ncu --import "$1/$3.ncu-rep" --csv --page "$2" >"$4/$3.csv"; }
    export -f list page
    for report in reports/*.ncu-rep; do
      name=$(basename "$report" .ncu-rep)
      printf '%s\n' "list $name" "page reports raw $name counters" "page reports source $name instructions" \
        "page driver_reports raw $name driver_counters"
    done | xargs -P "$(nproc)" -I{} bash -c '{} || echo "failed: {}"' 2>&1
    rm -rf reports driver_reports kept
  )
  printf '%s\n' "${failed[@]+"${failed[@]}"}" >"$work/failed.txt"
  tar -C "$work" -cJf "$out/exactness.tar.xz" .
  ls -la "$out"
  if ((${#failed[@]})); then
    echo "failed:"
    cat "$work/failed.txt"
  fi
  rm -rf "$work"
  ((${#failed[@]} == 0))
}

case ${1:-} in
  export) export_launches "${2:?LAUNCHES}" "${3:-build/release/cli/warpgrain}" ;;
  run) run_launches "${2:?LAUNCHES}" "${3:?OUT}" "${4:-build/release/cli/warpgrain}" ;;
  *) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; exit 2 ;;
esac

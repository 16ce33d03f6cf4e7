#!/usr/bin/env bash
# Runs a small sweep on a real Slurm of one machine and compares its table with that of a local run. The cluster (munged,
# slurmctld, slurmd) lives in a temporary folder and ends with the script. Needs root and the Debian packages slurmctld,
# slurmd, slurm-client and munge. Use: slurm.sh [MYOLOOP]      (default: build/bin/myoloop)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
myoloop=$(realpath -- "${1:-$root/build/bin/myoloop}")
limit_s=240   # for all jobs

((EUID == 0)) || { echo "slurm.sh: needs root, as which slurmd starts jobs" >&2; exit 2; }
[[ -x $myoloop ]] || { echo "slurm.sh: $myoloop is missing; build it first" >&2; exit 2; }
missing=()
for program in slurmctld:slurmctld slurmd:slurmd sbatch:slurm-client squeue:slurm-client munged:munge; do
  command -v "${program%%:*}" >/dev/null || missing+=("${program##*:}")
done
if ((${#missing[@]})); then
  echo "slurm.sh: missing packages; run: apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 2
fi

folder=$(mktemp -d)
daemons=()
own_cluster=false
stop() {
  local status=$?
  if $own_cluster; then scancel --user=root 2>/dev/null || true; fi
  local daemon
  for ((daemon = ${#daemons[@]} - 1; daemon >= 0; --daemon)); do
    kill "${daemons[daemon]}" 2>/dev/null || true
    wait "${daemons[daemon]}" 2>/dev/null || true
  done
  if ((status != 0)); then
    for log in "$folder"/*.log "$folder"/out/slurm/*.txt; do
      [[ -s $log ]] && { echo "== $log" >&2; tail -n 15 -- "$log" >&2; }
    done
  fi
  rm -rf -- "$folder"
  exit "$status"
}
trap stop EXIT

# munge tells the daemons who speaks to them. It refuses folders that others may write.
install -d -m 755 "$folder/munge"
chmod 755 "$folder"
dd if=/dev/urandom of="$folder/munge/key" bs=128 count=1 status=none
chmod 400 "$folder/munge/key"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
  --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" --log-file="$folder/munged.log" \
  >"$folder/munged_output.log" 2>&1 &
daemons+=($!)

host=$(hostname -s)
processors=$(nproc)
ports=($(comm -23 <(seq 20000 20999) <(ss -tanH 2>/dev/null | awk '{ sub(/.*:/, "", $4); print $4 }' | sort -u) |
  shuf -n 2))
cat >"$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$processors State=UNKNOWN
PartitionName=debug Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
CONF
mkdir -p "$folder/state" "$folder/spool"
export SLURM_CONF=$folder/slurm.conf
own_cluster=true
slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld_output.log" 2>&1 &
daemons+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >"$folder/slurmd_output.log" 2>&1 &
daemons+=($!)

until sinfo --noheader --format=%T 2>/dev/null | grep -q idle; do
  ((SECONDS < 60)) || { echo "slurm.sh: the cluster did not start" >&2; exit 1; }
  sleep 0.5
done
echo "slurm.sh: $(sinfo --version), $processors processors"

cat >"$folder/sweep.toml" <<SWEEP
schema = "sweep/1"
experiment = "$root/assets/examples/silicone_beam"
command = "simulate"
arguments = ["--resolution", "0.01"]
[[vary]]
key = "material.youngs_modulus_Pa"
values = [2.5e5, 3.0e5]
[[vary]]
key = "trial.tip_weight.load[0].mass_kg"
values = [0.012, 0.02]
SWEEP
"$myoloop" sweep "$folder/sweep.toml" --out "$folder/local" --quiet
"$myoloop" sweep "$folder/sweep.toml" --out "$folder/out" --slurm --partition debug --time 5 --nodes 2
# A record whose cases are finished: the tasks find nothing to do, and the last job makes the page.
cp -r -- "$root/assets/validation/seed_9" "$folder/validated"
"$myoloop" validate --seed 9 --cases 204 --out "$folder/validated" --slurm --partition debug --nodes 2

until [[ -z $(squeue --noheader) ]]; do
  ((SECONDS < limit_s)) || { echo "slurm.sh: the jobs did not end" >&2; squeue >&2; exit 1; }
  sleep 0.5
done

# Times and folders differ; everything else is to be the same to the last digit.
for table in local out; do
  [[ -s $folder/$table/sweep.html ]] || { echo "slurm.sh: no page in $table" >&2; exit 1; }
  grep -c ',done,' "$folder/$table/sweep.csv" | grep -qx 4 || { echo "slurm.sh: cases are missing" >&2; exit 1; }
  awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "seconds [s]") seconds = i } { $seconds = ""; print }' \
    "$folder/$table/sweep.csv" >"$folder/$table.csv"
done
diff "$folder/local.csv" "$folder/out.csv"
[[ -s $folder/validated/validation.html ]] || { echo "slurm.sh: validate has no page" >&2; exit 1; }
grep -q 'validation.html' "$folder/validated/slurm/collect.txt"
cmp "$root/assets/validation/seed_9/cases.jsonl" "$folder/validated/cases.jsonl"
echo "slurm.sh: the tables are equal, $((SECONDS)) s"

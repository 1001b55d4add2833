# Slurm of one machine on the loopback address, for tests; to be sourced. Needs no munge, no root and no /etc/slurm.
# shellcheck shell=bash

# How many cores the node has and where all of it lies: start_slurm FOLDER CORES. False where Slurm does not answer.
start_slurm() {
    local folder=$1 cores=$2 host user
    host=$(hostname -s)
    user=$(id -un)
    mkdir -p "$folder/state" "$folder/spool"
    cat >"$folder/slurm.conf" <<EOF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/none
CredType=cred/none
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
MinJobAge=300
SchedulerParameters=sched_interval=1,bf_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
EOF
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.out" 2>&1 &
    slurmctld_id=$!
    slurmd -D -f "$SLURM_CONF" >"$folder/slurmd.out" 2>&1 &
    slurmd_id=$!
    for _ in $(seq 60); do
        sinfo -h -o %t 2>/dev/null | grep -qE 'idle|mix|alloc' && return 0
        kill -0 "$slurmctld_id" "$slurmd_id" 2>/dev/null || return 1
        sleep 1
    done
    return 1
}

stop_slurm() {
    [ -z "${slurmctld_id:-}" ] || kill "$slurmctld_id" 2>/dev/null
    [ -z "${slurmd_id:-}" ] || kill "$slurmd_id" 2>/dev/null
    wait 2>/dev/null
    return 0
}

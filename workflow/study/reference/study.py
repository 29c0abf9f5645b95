"""Texts of the tables [study] and [cluster]."""

from .text import Text

STUDY = {
    "title": Text(
        "A line of text that heads the output of `plan`, the figure and the result file.",
        "No number depends on it.",
        default="the name of the study",
    ),
    "seed": Text(
        "The number from which every random line is drawn, together with the Hurst exponent, the "
        "number of elements and the index of the realization.",
        "Another seed, doubled or not, draws other lines: every estimate changes within its "
        "standard error.",
    ),
    "realizations": Text(
        "The number of random lines over which every estimate is averaged. It is rounded up to "
        "whole quartets, four lines from one set of random phases, and to at least two blocks.",
        "Doubled, the standard errors fall by √2 and the computing time doubles. Lines that are "
        "stored already are not computed again.",
        default='as many as were measured with `surface.lines = "measured"`, else required',
    ),
    "realizations_per_block": Text(
        "The number of lines whose mean is stored as one record. Blocks are the unit of the store "
        "and of the jackknife, which finds standard errors by leaving out one block, or with more "
        "than 32 blocks one group of blocks, at a time. For random lines it is rounded up to a "
        "multiple of four, and it must divide `realizations` into at least two blocks.",
        "Doubled, the store holds half as many records, and the standard error is itself known "
        "less well where there are fewer than 32 blocks. The estimates do not change.",
    ),
}
CLUSTER = {
    "where": Text(
        "Where batches are computed: on the cores of this machine, as jobs of SLURM, or by a Dask "
        "scheduler that runs at the given address.",
        "No number depends on it.",
        values='`"local"`, `"slurm"`, `"tls://host:port"` or `"tcp://host:port"`',
    ),
    "patience": Text(
        "How long a run waits while there is no worker, no answer from any worker, or no disk "
        "that can be written.",
        "Doubled, a run gives up after twice the time.",
        "s",
    ),
    "jobs": Text(
        "The number of jobs that are asked of the batch system.",
        "Doubled, twice as many workers compute, as far as the queue grants them.",
    ),
    "cores": Text(
        "The number of cores of each job. Each runs one worker of one thread.",
        "Doubled, each job has twice as many workers, which share `memory`.",
    ),
    "memory": Text(
        "The memory of each job. `plan` predicts what a worker needs.",
        "Doubled, each worker may use twice as much before it is ended; nothing gets quicker.",
        values='a size such as `"4GB"`',
    ),
    "walltime": Text(
        "The time after which the batch system ends a job. Workers retire at nine tenths of it "
        "and are replaced; no batch is predicted to take longer than a twentieth of that.",
        "Doubled, workers are replaced half as often, and jobs may wait longer in the queue.",
        values='a time such as `"12:00:00"` or `"1-00:00:00"`, at least a minute',
    ),
    "queue": Text(
        "The queue, or partition, of the batch system.",
        "No number depends on it.",
        values="one word",
        default="that of the batch system",
    ),
    "account": Text(
        "The account to which the jobs are charged.",
        "No number depends on it.",
        values="one word",
        default="that of the batch system",
    ),
    "interface": Text(
        'The network interface by which nodes reach each other, such as `"ib0"`.',
        "No number depends on it.",
        values="one word",
        default="that which the system chooses",
    ),
    "log_folder": Text(
        "The folder for what jobs print, from the working folder. While a run lasts, its "
        "certificates lie beside it, so every node must see it.",
        "No number depends on it.",
        values="one line of text",
    ),
    "prologue": Text(
        "Lines of the job script before the workers start, such as "
        '`["module load python"]`. They run with your rights.',
        "No number depends on it.",
        values="one line of text, or a list of them",
        default="none",
    ),
    "tls_ca_file": Text(
        "A PEM file with the certificate of who has signed those of a scheduler `tls://…`.",
        "No number depends on it.",
        values="the path of a file",
        default="none",
    ),
    "tls_cert": Text(
        "A PEM file with the certificate that shows that scheduler who you are.",
        "No number depends on it.",
        values="the path of a file",
        default="none",
    ),
    "tls_key": Text(
        "A PEM file with the key of that certificate, unless the certificate's file holds it.",
        "No number depends on it.",
        values="the path of a file",
        default="none",
    ),
}

"""The study's own experiment: placeholder until flights are wired."""

from ins_eval.study.run.run import Experiment

EXPERIMENT = Experiment(made=lambda study, triads: {}, conclude=lambda s, a, f: None, files=())

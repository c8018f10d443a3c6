from .bench.session import list_tests, run_test, run_tests
from .challenge.run import run_challenge
from .common.errors import HrgError
from .device.device import Device
from .device.ready_devices import load_device
from .gap.campaign_diagnosis import CampaignDiagnosis
from .gap.closing.prediction import predict
from .gap.diagnose import diagnose
from .gap.findings.diagnosis_reader import read_diagnosis
from .gap.static_record import compute_allan, diagnose_record
from .noise.allan import allan_deviation
from .playback import simulate
from .records.campaign import Campaign, read_campaign, write_campaign
from .records.campaign_import import ImportedCampaign, import_campaign
from .records.log import Log, read_log, write_log
from .witness.estimate import MapEstimate, estimate_map
from .witness.estimator import prepare_estimator
from .witness.prior import make_drift_prior

__all__ = [
    "Campaign",
    "CampaignDiagnosis",
    "Device",
    "HrgError",
    "ImportedCampaign",
    "Log",
    "MapEstimate",
    "allan_deviation",
    "compute_allan",
    "diagnose",
    "diagnose_record",
    "estimate_map",
    "import_campaign",
    "list_tests",
    "load_device",
    "make_drift_prior",
    "predict",
    "prepare_estimator",
    "read_campaign",
    "read_diagnosis",
    "read_log",
    "run_challenge",
    "run_test",
    "run_tests",
    "simulate",
    "write_campaign",
    "write_log",
]

"""Errors of the bench on which a gyro is recorded; the FMU does not have them."""

from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG, HZ, PPM
from pyhrg.device.declarations import ToleranceDeclaration, parameter


@dataclass(frozen=True)
class LaboratoryParameters:
    """What the instruments of a bench read wrongly, and what was told wrongly of it; SI."""

    frequency_error: float = parameter(
        key="frequency_error_Hz",
        unit=HZ,
        limits=(-1000, 1000),
        known=ToleranceDeclaration("nominal_frequency", "nominal", 1 * HZ, 7 * HZ),
    )
    """True modal frequency less the one from which the frequency offset counts, rad/s."""
    thermometer_offset: float = parameter(
        key="thermometer_offset_K",
        limits=(-100, 100),
        known=ToleranceDeclaration("thermometer_offset", "bench", 1.0, 0.2),
    )
    """Reading of the case thermometer less the case's temperature, K."""
    thermometer_lag: float = parameter(
        key="thermometer_lag_s",
        limits=(-3600, 3600),
        known=ToleranceDeclaration("thermometer_lag", "bench", 60.0, 20.0),
    )
    """Time constant of the thermometer's reading behind the case, s."""
    thermometer_gain: float = parameter(
        key="thermometer_gain",
        limits=(-0.5, 0.5),
        known=ToleranceDeclaration("thermometer_gain", "bench", 0.1, 0.002),
    )
    """Change of the reading over the change of the case's temperature, less one."""
    latitude_error: float = parameter(
        key="latitude_error_deg",
        unit=DEG,
        limits=(-180, 180),
        known=ToleranceDeclaration("site_latitude", "bench", 0.1 * DEG, 0.01 * DEG),
    )
    """True less stated latitude of the site, rad. A tilt of the table's axis to the north does the
    same to an upright axis."""
    encoder_eccentricity: float = parameter(
        key="encoder_eccentricity_arcsec",
        unit=ARCSEC,
        limits=(0, 3600),
        known=ToleranceDeclaration(
            "encoder_eccentricity",
            "bench",
            10 * ARCSEC,
            1 * ARCSEC,
            angle="encoder_eccentricity_phase",
            periods=1,
        ),
    )
    """Amplitude of the encoder's error over one turn of the table, rad."""
    encoder_eccentricity_phase: float = parameter(
        key="encoder_eccentricity_phase_deg", unit=DEG, limits=(-360, 360)
    )
    """Phase of that error, rad: the true rate is the one read times 1 + a cos(reading + phase)."""
    clock_latency: float = parameter(
        key="clock_latency_s",
        limits=(-1, 1),
        known=ToleranceDeclaration("clock_latency", "record", 1e-4, 1e-5),
    )
    """Time by which the gyro's angle is read later than the encoder, s."""
    clock_rate: float = parameter(
        key="clock_rate_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        known=ToleranceDeclaration("clock_rate", "record", 10 * PPM, 1 * PPM),
    )
    """Growth of that time with the time since power-on, s/s."""

package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;

/**
 * The reverse density of a BSDF sample: with which the surface would have sampled the direction that the path came from, had it come from
 * the other side.
 */
public final class ReverseDensity {
    private final Scattering turned = new Scattering();

    /** The density of direction o per solid angle, as if the path had come from direction i. */
    public double of(Bsdf bsdf, Scattering s) {
        boolean passes = s.ix * s.nx + s.iy * s.ny + s.iz * s.nz < 0 && bsdf.transmits();
        double side = passes ? -1 : 1;
        turned.ox = s.ix;
        turned.oy = s.iy;
        turned.oz = s.iz;
        turned.ix = s.ox;
        turned.iy = s.oy;
        turned.iz = s.oz;
        turned.nx = side * s.nx;
        turned.ny = side * s.ny;
        turned.nz = side * s.nz;
        turned.gx = side * s.gx;
        turned.gy = side * s.gy;
        turned.gz = side * s.gz;
        turned.red = s.red;
        turned.green = s.green;
        turned.blue = s.blue;
        turned.eta = passes ? 1 / s.eta : s.eta;
        return bsdf.pdf(turned);
    }
}

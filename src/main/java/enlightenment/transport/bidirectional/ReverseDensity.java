package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;

/** The density with which a surface would scatter the other way round: towards where a path came from, if it came from where it goes. */
public final class ReverseDensity {
    private final Scattering turned = new Scattering();

    /** Per solid angle of the direction o, as if the path had come from the direction i. */
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

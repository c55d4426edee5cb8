package enlightenment.bsdf;

import enlightenment.math.Vec3;
import enlightenment.sampling.DirectionChiSquare;

/** A place on a surface with a normal of no special direction, and local directions there: what the tests of this package share. */
final class Place implements DirectionChiSquare.Sampled {
    final Scattering s = new Scattering();
    final Bsdf bsdf;
    private final Vec3 n;
    private final Vec3 e;
    private final Vec3 f;

    Place(Bsdf bsdf, Vec3 normal) {
        this.bsdf = bsdf;
        n = normal.normalized();
        e = (Math.abs(n.x()) < 0.9 ? Vec3.X : Vec3.Y).cross(n).normalized();
        f = n.cross(e);
        s.nx = n.x();
        s.ny = n.y();
        s.nz = n.z();
    }

    /** A place that is seen from a direction of this cosine, in the plane of x and normal. */
    static Place seen(Bsdf bsdf, double cosine) {
        return new Place(bsdf, new Vec3(0.48, -0.6, 0.64)).from(cosine, 0.7);
    }

    Place color(double r, double g, double b) {
        s.red = r;
        s.green = g;
        s.blue = b;
        return this;
    }

    Place eta(double eta) {
        s.eta = eta;
        return this;
    }

    Place from(double cosine, double turn) {
        Vec3 o = direction(cosine, turn);
        s.ox = o.x();
        s.oy = o.y();
        s.oz = o.z();
        return this;
    }

    Place to(double cosine, double turn) {
        Vec3 i = direction(cosine, turn);
        s.ix = i.x();
        s.iy = i.y();
        s.iz = i.z();
        return this;
    }

    Vec3 direction(double cosine, double turn) {
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        return n.times(cosine)
                .plus(e.times(sine * Math.cos(turn)))
                .plus(f.times(sine * Math.sin(turn)))
                .normalized();
    }

    Vec3 normal() {
        return n;
    }

    /** Where o's mirror image is. */
    Vec3 mirrored() {
        return n.times(2 * n.dot(o())).minus(o());
    }

    Vec3 o() {
        return new Vec3(s.ox, s.oy, s.oz);
    }

    Vec3 i() {
        return new Vec3(s.ix, s.iy, s.iz);
    }

    /** Exchanges the two directions; to the other side also the sides. */
    void exchange() {
        Vec3 o = o();
        boolean through = s.cosineIn() < 0;
        s.ox = s.ix;
        s.oy = s.iy;
        s.oz = s.iz;
        s.ix = o.x();
        s.iy = o.y();
        s.iz = o.z();
        if (through) {
            s.nx = -s.nx;
            s.ny = -s.ny;
            s.nz = -s.nz;
            s.eta = 1 / s.eta;
        }
    }

    /** The first component of f, without the cosine. */
    double f() {
        bsdf.evaluate(s);
        return s.valueR / Math.abs(s.cosineIn());
    }

    double valueAt(double x, double y, double z) {
        s.ix = x;
        s.iy = y;
        s.iz = z;
        bsdf.evaluate(s);
        return s.valueR;
    }

    @Override
    public boolean sample(double u, double v, double choice, double[] out) {
        if (!bsdf.sample(s, u, v, choice) || s.delta) {
            return false;
        }
        out[0] = s.ix;
        out[1] = s.iy;
        out[2] = s.iz;
        return true;
    }

    @Override
    public double pdf(double x, double y, double z) {
        s.ix = x;
        s.iy = y;
        s.iz = z;
        return bsdf.pdf(s);
    }

    /** What is reflected only, or what is transmitted only; the rest counts as rejected. */
    DirectionChiSquare.Sampled only(boolean through) {
        return new DirectionChiSquare.Sampled() {
            @Override
            public boolean sample(double u, double v, double choice, double[] out) {
                return Place.this.sample(u, v, choice, out) && s.transmitted == through;
            }

            @Override
            public double pdf(double x, double y, double z) {
                double p = Place.this.pdf(x, y, z);
                return s.cosineIn() < 0 == through ? p : 0;
            }
        };
    }
}

package enlightenment.primitive;

import enlightenment.math.Vec3;

/**
 * Where a ray meets a surface. A mutable result object: it is filled in once the closest crossing is known, never for a
 * surface that was merely tested, and hot loops reuse one instance.
 */
public final class Hit {
    /** The ray parameter of the crossing. */
    public double t;

    /** The crossing point, projected onto the surface: within a few units in the last place of it. */
    public double px;

    public double py;
    public double pz;

    /** The unit normal that points to {@link Ray#OUTSIDE}. */
    public double nx;

    public double ny;
    public double nz;

    /** The side that the ray arrives on: {@link Ray#OUTSIDE} where it enters a solid, {@link Ray#INSIDE} where it leaves. */
    public int side;

    /** Which face of the primitive; its meaning is the primitive's. */
    public int face;

    /** Which element of a primitive that has many, such as a triangle of a mesh; of others it means nothing. */
    public int element;

    /** Of a triangle of a mesh, the weights of its second and third corner at the crossing. */
    double weightB;

    double weightC;

    /** The unit normal that surfaces are shaded by, which points to {@link Ray#OUTSIDE}; set by {@link Primitive#shadingNormal}. */
    public double sx;

    public double sy;
    public double sz;

    /** The primitive that was hit. */
    public Primitive primitive;

    /** Texture coordinates, 0..1: u to the right, v downwards; set by {@link Primitive#textureCoordinates}. */
    public double u;

    public double v;

    /** Scratch that a primitive sets when it finds its crossing and reads when it completes the hit. */
    double along;

    /** An empty result. */
    public Hit() {}

    /** Copies another result. */
    public void set(Hit o) {
        t = o.t;
        px = o.px;
        py = o.py;
        pz = o.pz;
        nx = o.nx;
        ny = o.ny;
        nz = o.nz;
        side = o.side;
        face = o.face;
        element = o.element;
        weightB = o.weightB;
        weightC = o.weightC;
        sx = o.sx;
        sy = o.sy;
        sz = o.sz;
        primitive = o.primitive;
        u = o.u;
        v = o.v;
        along = o.along;
    }

    /** The crossing point (px, py, pz). */
    public Vec3 point() {
        return new Vec3(px, py, pz);
    }

    /** The unit normal (nx, ny, nz). */
    public Vec3 normal() {
        return new Vec3(nx, ny, nz);
    }

    void setPoint(double x, double y, double z) {
        px = x;
        py = y;
        pz = z;
    }

    /** Sets the normal to the direction (x, y, z), normalised here. */
    void setNormal(double x, double y, double z) {
        double s = 1 / Math.sqrt(x * x + y * y + z * z);
        nx = x * s;
        ny = y * s;
        nz = z * s;
    }
}

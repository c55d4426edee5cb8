package enlightenment.primitive;

import enlightenment.math.Vec3;

/**
 * The crossing of a ray and a surface. A mutable result object: it is filled in once the closest crossing is known, never for a surface
 * that was merely tested, and hot loops reuse one instance.
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

    /** The face of the primitive, numbered by the primitive. */
    public int face;

    /** The element of a primitive that has many, such as a triangle of a mesh; undefined for others. */
    public int element;

    /** Of a triangle of a mesh, the weights of its second and third corner at the crossing. */
    double weightB;

    double weightC;

    /** The shading normal, of length 1, which points to {@link Ray#OUTSIDE}; set by {@link Primitive#shadingNormal}. */
    public double sx;

    public double sy;
    public double sz;

    /**
     * The vectors of the texture along which its coordinates grow by 1: u to the right, v upwards; set by
     * {@link Primitive#textureDirections}.
     */
    double ux;

    double uy;
    double uz;
    double vx;
    double vy;
    double vz;

    /** The primitive that was hit. */
    public Primitive primitive;

    /** Texture coordinates, 0..1: u to the right, v downwards; set by {@link Primitive#textureCoordinates}. */
    public double u;

    public double v;

    /** Scratch of the primitive, between finding a crossing and completing the hit. */
    double along;

    /** Makes an empty result. */
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

    void setTextureDirections(Vec3 u, Vec3 v) {
        ux = u.x();
        uy = u.y();
        uz = u.z();
        vx = v.x();
        vy = v.y();
        vz = v.z();
    }

    /** Sets the shading normal to the geometric one. */
    public void shadeByOwnNormal() {
        sx = nx;
        sy = ny;
        sz = nz;
    }

    /**
     * Turns the shading normal to a direction given in the basis of the texture's u, its v, and the normal so far.
     *
     * @return whether the direction exists and is on the outside of the surface; if not, nothing is changed
     */
    public boolean turnShadingNormal(double x, double y, double z) {
        double along = sx * ux + sy * uy + sz * uz;
        double tx = ux - along * sx;
        double ty = uy - along * sy;
        double tz = uz - along * sz;
        double t = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz);
        double bx = sy * tz - sz * ty;
        double by = sz * tx - sx * tz;
        double bz = sx * ty - sy * tx;
        double b = bx * vx + by * vy + bz * vz < 0 ? -t : t;
        return shadeBy(
                x * t * tx + y * b * bx + z * sx, x * t * ty + y * b * by + z * sy, x * t * tz + y * b * bz + z * sz);
    }

    /**
     * Turns the shading normal to that of a surface displaced along it by a height that grows along the texture's directions, which need
     * not be at right angles.
     *
     * @param du growth of the height per unit of u
     * @param dv growth of the height per unit of v
     * @return whether the direction exists and is on the outside of the surface; if not, nothing is changed
     */
    public boolean tiltShadingNormal(double du, double dv) {
        double u = sx * ux + sy * uy + sz * uz;
        double v = sx * vx + sy * vy + sz * vz;
        double ax = ux - u * sx;
        double ay = uy - u * sy;
        double az = uz - u * sz;
        double bx = vx - v * sx;
        double by = vy - v * sy;
        double bz = vz - v * sz;
        // The gradient g in the plane of the normal s with g·a = du and g·b = dv: (du b × s + dv s × a) / s·(a × b).
        double area = sx * (ay * bz - az * by) + sy * (az * bx - ax * bz) + sz * (ax * by - ay * bx);
        double x = du * (by * sz - bz * sy) + dv * (sy * az - sz * ay);
        double y = du * (bz * sx - bx * sz) + dv * (sz * ax - sx * az);
        double z = du * (bx * sy - by * sx) + dv * (sx * ay - sy * ax);
        return shadeBy(sx - x / area, sy - y / area, sz - z / area);
    }

    private boolean shadeBy(double px, double py, double pz) {
        double length = Math.sqrt(px * px + py * py + pz * pz);
        if (!(length > 0 && length < Double.POSITIVE_INFINITY && px * nx + py * ny + pz * nz > 0)) {
            return false;
        }
        sx = px / length;
        sy = py / length;
        sz = pz / length;
        return true;
    }

    /** Sets the normal to the direction (x, y, z), normalised here. */
    void setNormal(double x, double y, double z) {
        double s = 1 / Math.sqrt(x * x + y * y + z * z);
        nx = x * s;
        ny = y * s;
        nz = z * s;
    }
}

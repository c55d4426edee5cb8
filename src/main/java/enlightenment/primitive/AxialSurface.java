package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Angles;
import enlightenment.numeric.Products;

/** The surface of a cylinder or cone: the point, normal and texture coordinates of a crossing whose face is known. */
final class AxialSurface {
    private static final double TWO_PI = 2 * Math.PI;

    private final AxialPrimitive solid;

    /** The lateral normal has tiltAcross parts away from the axis and tiltAlong parts towards the narrower end. */
    private final double tiltAcross;

    private final double tiltAlong;

    /** The direction from the axis to the texture's seam, and the one in which u grows there: a basis across the axis. */
    private final Vec3 seam;

    private final Vec3 east;

    /** @param solid the primitive whose surface this is; its form, up to the unit axis, is known */
    AxialSurface(AxialPrimitive solid) {
        this.solid = solid;
        Vec3 slant = new Vec3(solid.axis.length(), solid.wideRadius - solid.narrowRadius, 0).normalized();
        tiltAcross = slant.x();
        tiltAlong = slant.y();
        seam = Disks.seam(solid.unitAxis);
        east = seam.cross(solid.narrowIsTop ? solid.unitAxis.negated() : solid.unitAxis);
    }

    /** Sets point and normal of a hit whose face, side and {@link Hit#along} are set. */
    void complete(Ray ray, Hit hit) {
        double fx = ray.ox - solid.cx;
        double fy = ray.oy - solid.cy;
        double fz = ray.oz - solid.cz;
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        if (hit.face == AxialPrimitive.LATERAL) {
            completeLateral(ray, mx, my, mz, hit);
        } else {
            completeEnd(ray, mx, my, mz, hit);
        }
    }

    private void completeLateral(Ray ray, double mx, double my, double mz, Hit hit) {
        // The crossing relative to the reference point: F + along·d.
        double px = Math.fma(hit.along, ray.dx, Products.difference(ray.dy, mz, ray.dz, my) / ray.dd);
        double py = Math.fma(hit.along, ray.dy, Products.difference(ray.dz, mx, ray.dx, mz) / ray.dd);
        double pz = Math.fma(hit.along, ray.dz, Products.difference(ray.dx, my, ray.dy, mx) / ray.dd);
        double ex = solid.unitAxis.x();
        double ey = solid.unitAxis.y();
        double ez = solid.unitAxis.z();
        double wx = Products.difference(py, ez, pz, ey);
        double wy = Products.difference(pz, ex, px, ez);
        double wz = Products.difference(px, ey, py, ex);
        double radial = Math.sqrt(wx * wx + wy * wy + wz * wz);
        // The position along the axis, 0..1: on a flat cone the distance from the axis gives it more accurately.
        double fraction = solid.slope > 1
                ? (radial - solid.narrowRadius) / (solid.wideRadius - solid.narrowRadius)
                : Products.dot(px, py, pz, solid.ax, solid.ay, solid.az) / solid.extent;
        fraction = Watertight.clamp01(fraction);
        double r = Math.fma(solid.wideRadius - solid.narrowRadius, fraction, solid.narrowRadius);
        if (radial > 0) {
            hit.setNormal(
                    Products.difference(ey, wz, ez, wy),
                    Products.difference(ez, wx, ex, wz),
                    Products.difference(ex, wy, ey, wx));
        } else {
            // At the apex itself any direction across the axis will do.
            hit.setNormal(seam.x(), seam.y(), seam.z());
        }
        hit.setPoint(
                Math.fma(r, hit.nx, Math.fma(fraction, solid.axis.x(), solid.cx)),
                Math.fma(r, hit.ny, Math.fma(fraction, solid.axis.y(), solid.cy)),
                Math.fma(r, hit.nz, Math.fma(fraction, solid.axis.z(), solid.cz)));
        if (tiltAlong > 0) {
            hit.setNormal(
                    Math.fma(tiltAcross, hit.nx, -tiltAlong * ex),
                    Math.fma(tiltAcross, hit.ny, -tiltAlong * ey),
                    Math.fma(tiltAcross, hit.nz, -tiltAlong * ez));
        }
    }

    private void completeEnd(Ray ray, double mx, double my, double mz, Hit hit) {
        boolean narrow = (hit.face == AxialPrimitive.TOP) == solid.narrowIsTop;
        double sign = narrow ? -1 : 1;
        hit.nx = sign * solid.unitAxis.x();
        hit.ny = sign * solid.unitAxis.y();
        hit.nz = sign * solid.unitAxis.z();
        Vec3 center = narrow ? new Vec3(solid.cx, solid.cy, solid.cz) : solid.wide();
        if (hit.along == hit.along) {
            // The ray leaves where it starts: that point, projected onto the plane.
            Vec3 p = new Vec3(ray.ox, ray.oy, ray.oz).minus(center);
            Vec3 q = p.minus(solid.unitAxis.times(p.dot(solid.unitAxis)));
            hit.setPoint(center.x() + q.x(), center.y() + q.y(), center.z() + q.z());
            return;
        }
        double e = Products.dot(ray.dx, ray.dy, ray.dz, solid.ax, solid.ay, solid.az);
        // The moment about the centre of this end; the line meets the end's plane at A × moment / (d·A) from there.
        double kx = narrow ? mx : Math.fma(solid.unit, Products.difference(ray.dy, solid.az, ray.dz, solid.ay), mx);
        double ky = narrow ? my : Math.fma(solid.unit, Products.difference(ray.dz, solid.ax, ray.dx, solid.az), my);
        double kz = narrow ? mz : Math.fma(solid.unit, Products.difference(ray.dx, solid.ay, ray.dy, solid.ax), mz);
        hit.setPoint(
                center.x() + Products.difference(solid.ay, kz, solid.az, ky) / e,
                center.y() + Products.difference(solid.az, kx, solid.ax, kz) / e,
                center.z() + Products.difference(solid.ax, ky, solid.ay, kx) / e);
    }

    /** Sets the texture coordinates of a hit: on the lateral surface u runs around the axis and v from the top down. */
    void textureCoordinates(Hit hit) {
        if (hit.face != AxialPrimitive.LATERAL) {
            boolean atTop = hit.face == AxialPrimitive.TOP;
            Vec3 p = hit.point().minus(atTop ? solid.top() : solid.base());
            double r = atTop ? solid.topRadius() : solid.baseRadius();
            Disks.textureCoordinates(hit, p, east, atTop ? seam.negated() : seam, r);
            return;
        }
        Vec3 p = hit.point().minus(solid.base());
        double turn = Angles.atan2(p.dot(east), p.dot(seam)) / TWO_PI;
        hit.u = turn < 0 ? turn + 1 : turn;
        Vec3 q = hit.point().minus(new Vec3(solid.cx, solid.cy, solid.cz));
        double fraction = Products.dot(q.x(), q.y(), q.z(), solid.ax, solid.ay, solid.az) / solid.extent;
        hit.v = Watertight.clamp01(solid.narrowIsTop ? fraction : 1 - fraction);
    }

    /** The numbers of the surface for code on another device. */
    double[] flatForm() {
        return new double[] {tiltAcross, tiltAlong, seam.x(), seam.y(), seam.z(), east.x(), east.y(), east.z()};
    }
}

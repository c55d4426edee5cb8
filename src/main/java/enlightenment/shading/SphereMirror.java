package enlightenment.shading;

/**
 * Where a ball that is a mirror shows a point the middle of a light: Alhazen's problem. A mutable work object, one per thread.
 *
 * <p>The point lies in the plane of the ball's centre, the viewer and the light, between the two points of the ball that are nearest to
 * them; there the tangential parts of the directions to viewer and light cancel, and their sum falls from the one to the other. Halving
 * the arc finds it.
 */
final class SphereMirror {
    /** The arc is halved so often: to less than a ten-millionth of a radian. */
    private static final int HALVINGS = 24;

    /** The cone is this much wider than what a light covers in it by the first derivatives of the reflection. */
    private static final double WIDER = 1.25;

    /** The widest cone: beyond, derivatives say little. */
    private static final double WIDEST_SINE = 0.5;

    private double px;
    private double py;
    private double pz;

    /** The unit vector from the viewer to the point. */
    double wx;

    double wy;
    double wz;

    /** The cosine of the half angle of a cone that covers about all directions in which the light is seen; above 1 if there is none. */
    double cosine;

    /** 1 − that. */
    double oneMinusCosine;

    /**
     * Sets the cone in which a viewer sees a light in a ball.
     *
     * @param cx the vector from the viewer to the centre of the ball
     * @param radius the radius of the ball
     * @param lx the vector from the viewer to the middle of the light
     * @param lightRadius the radius of a ball around the light
     */
    void aim(double cx, double cy, double cz, double radius, double lx, double ly, double lz, double lightRadius) {
        cosine = 2;
        double toViewer = Math.sqrt(cx * cx + cy * cy + cz * cz);
        double tx = lx - cx;
        double ty = ly - cy;
        double tz = lz - cz;
        double toLight = Math.sqrt(tx * tx + ty * ty + tz * tz);
        if (!(toViewer > radius) || !(toLight > radius)) {
            return;
        }
        double ux = -cx / toViewer;
        double uy = -cy / toViewer;
        double uz = -cz / toViewer;
        double vx = tx / toLight;
        double vy = ty / toLight;
        double vz = tz / toLight;
        double sx = ux;
        double sy = uy;
        double sz = uz;
        for (int k = 0; k < HALVINGS; k++) {
            double mx = ux + vx;
            double my = uy + vy;
            double mz = uz + vz;
            double scale = 1 / Math.sqrt(mx * mx + my * my + mz * mz);
            if (!(scale < Double.POSITIVE_INFINITY)) {
                return;
            }
            sx = mx * scale;
            sy = my * scale;
            sz = mz * scale;
            if (leansToLight(sx, sy, sz, cx, cy, cz, radius, lx, ly, lz, vx - ux, vy - uy, vz - uz)) {
                ux = sx;
                uy = sy;
                uz = sz;
            } else {
                vx = sx;
                vy = sy;
                vz = sz;
            }
        }
        finish(sx, sy, sz, lx, ly, lz, radius, lightRadius);
    }

    /** Whether the point lies farther along the arc, whose direction is d. */
    private boolean leansToLight(
            double nx,
            double ny,
            double nz,
            double cx,
            double cy,
            double cz,
            double radius,
            double lx,
            double ly,
            double lz,
            double dx,
            double dy,
            double dz) {
        px = cx + radius * nx;
        py = cy + radius * ny;
        pz = cz + radius * nz;
        double qx = lx - px;
        double qy = ly - py;
        double qz = lz - pz;
        double toLight = 1 / Math.sqrt(qx * qx + qy * qy + qz * qz);
        double toViewer = 1 / Math.sqrt(px * px + py * py + pz * pz);
        double hx = qx * toLight - px * toViewer;
        double hy = qy * toLight - py * toViewer;
        double hz = qz * toLight - pz * toViewer;
        // The middle of the arc is across its chord: what h has along the chord is its tangential part.
        return hx * dx + hy * dy + hz * dz > 0;
    }

    private void finish(
            double nx, double ny, double nz, double lx, double ly, double lz, double radius, double lightRadius) {
        double a = Math.sqrt(px * px + py * py + pz * pz);
        double qx = lx - px;
        double qy = ly - py;
        double qz = lz - pz;
        double b = Math.sqrt(qx * qx + qy * qy + qz * qz);
        wx = px / a;
        wy = py / a;
        wz = pz / a;
        double incidence = -(wx * nx + wy * ny + wz * nz);
        if (!(incidence > 0)) {
            return;
        }
        // A turn by ω at the viewer moves what is seen by (a + b) ω, and by twice the turn of the normal: across the
        // plane of
        // reflection the least.
        double sine = Math.min(WIDER * lightRadius / (a + b + 2 * a * b * incidence / radius), WIDEST_SINE);
        double c = Math.sqrt((1 - sine) * (1 + sine));
        oneMinusCosine = sine * sine / (1 + c);
        cosine = 1 - oneMinusCosine;
    }
}

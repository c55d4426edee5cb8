package enlightenment.shading;

import enlightenment.compiled.HomogeneousMedium;

/** A beam of {@link MediumBeams}: straight light from the border of a medium on. */
final class MediumBeam {
    /** Of what is dimmed by a factor of e to this power nothing is left. */
    private static final double GONE = 6;

    /** What has less of its path's power left is of no matter. */
    private static final double FAINT = 0x1p-9;

    final HomogeneousMedium medium;

    /** Of lights that are about as hard to find. */
    final int group;

    /** Where it begins. */
    final double x;

    final double y;
    final double z;

    /** Its direction. */
    final double dx;

    final double dy;
    final double dz;

    /** The border's normal there, with a positive part along the direction. */
    private double nx;

    private double ny;
    private double nz;

    /** The cosine of the two. */
    private double cosine;

    /** The power that begins here; after {@link #spreadBy} that of a path's share in all. */
    double red;

    double green;
    double blue;

    /** Of the light that it comes from; 0 of a point. */
    double radiance;

    /** How many events it has behind it. */
    int bounces;

    /** How far it goes to the next surface. */
    double length;

    /** Of the disk of the border that it is spread over. */
    private double radius;

    /** How far it goes with any effect. */
    private double reach;

    MediumBeam(HomogeneousMedium medium, int group, double[] start, double dx, double dy, double dz) {
        this.medium = medium;
        this.group = group;
        x = start[0];
        y = start[1];
        z = start[2];
        this.dx = dx;
        this.dy = dy;
        this.dz = dz;
    }

    /** Sets the border's normal, on either side. */
    void leaves(double normalX, double normalY, double normalZ) {
        double dot = normalX * dx + normalY * dy + normalZ * dz;
        double sign = dot < 0 ? -1 : 1;
        nx = sign * normalX;
        ny = sign * normalY;
        nz = sign * normalZ;
        cosine = sign * dot;
    }

    void carries(double r, double g, double b, double ofRadiance, int events) {
        red = r;
        green = g;
        blue = b;
        radiance = ofRadiance;
        bounces = events;
    }

    /** @param most of what its path began with */
    boolean isUsable(double most) {
        return cosine > 0 && Math.max(red, Math.max(green, blue)) > FAINT * most;
    }

    /** Spreads it over a disk of this radius; it is one of so many paths. */
    void spreadBy(double r, int paths) {
        radius = r;
        double least = Math.min(medium.extinctionR, Math.min(medium.extinctionG, medium.extinctionB));
        double visible = least > 0 ? GONE / least : Double.POSITIVE_INFINITY;
        reach = Math.min(length + radius, visible);
        red /= paths;
        green /= paths;
        blue /= paths;
    }

    /** How far it reaches with any effect, from its start on. */
    double reach() {
        return reach;
    }

    double radius() {
        return radius;
    }

    /** How far light has come from the border where it is at a point; negative if the beam does not pass there. */
    double depth(double px, double py, double pz) {
        double ex = px - x;
        double ey = py - y;
        double ez = pz - z;
        double deep = (ex * nx + ey * ny + ez * nz) / cosine;
        if (!(deep >= 0 && deep <= reach)) {
            return -1;
        }
        double ax = ex - deep * dx;
        double ay = ey - deep * dy;
        double az = ez - deep * dz;
        return ax * ax + ay * ay + az * az <= radius * radius ? deep : -1;
    }

    /** The inverse of its area, perpendicular to its direction. */
    double spread() {
        return 1 / (Math.PI * radius * radius * cosine);
    }
}

package enlightenment.bench;

import enlightenment.frame.Basis;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.SobolSampler;
import enlightenment.sampling.Warp;

/**
 * Path tracing of one scene that is written into the code: plain fire and ice, {@code src/bench/scenes/fire-and-ice-plain-physical.json}.
 * The random numbers, the closed form of the sphere's irradiance and the roulette are those of method {@code raytrace}; robust
 * intersections, caustics, the film and everything else that makes it a renderer are left out. Its time is what a path costs at least if
 * one path follows the other: a figure to compare with, not a second renderer.
 */
final class FlatRoom {
    private static final int BALLS = 3;
    private static final double[] CENTER_X = {-2, 2, 0};
    private static final double[] CENTER_Y = {1, 1, 3};
    private static final double[] CENTER_Z = {4, 4, 4};
    private static final double[] RADIUS = {1.5, 1.5, 0.75};

    private static final int MIRROR = 2;
    private static final int LEFT = 3;
    private static final int RIGHT = 4;
    private static final int FLOOR = 5;
    private static final int CEILING = 6;
    private static final int BACK = 7;
    private static final int LAMP = 8;
    private static final int NOTHING = -1;

    /** Of each surface: the balls, then left, right, floor, ceiling, back. */
    private static final double[] RED = {0.7, 0.2, 1, 0.7, 0.15, 0.7, 0.7, 0.7};

    private static final double[] GREEN = {0.2, 0.2, 1, 0.15, 0.7, 0.7, 0.7, 0.7};
    private static final double[] BLUE = {0.2, 0.7, 1, 0.15, 0.15, 0.7, 0.7, 0.7};

    private static final double HALF_WIDTH = 6;
    private static final double FRONT = -2;
    private static final double DEPTH = 8;

    private static final double LAMP_X = 0;
    private static final double LAMP_Y = 1;
    private static final double LAMP_Z = 1;
    private static final double LAMP_RADIUS = 0.15;
    private static final double RADIANCE = 200;

    private static final int NONE_OF_IT = 0;
    private static final int ALL_OF_IT = 1;
    private static final int PERHAPS = 2;

    private static final int FIRST_ROULETTE = 5;
    private static final double FAINT = 0.05;
    private static final double LIKELIEST_TO_GO_ON = 0.99;

    private final SobolSampler sampler = new SobolSampler();
    private final double[] pair = new double[2];
    private final double[] disk = new double[3];
    private final Basis basis = new Basis();

    /** Of the last hit. */
    private double distance;

    /** Radiance of the last path, W/(m² sr). */
    private double red;

    private double green;
    private double blue;

    /** The mean radiance of the green band over a picture. */
    double mean(int width, int height, int samples) {
        double sum = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                sampler.pixel(1, x, y);
                for (int sample = 0; sample < samples; sample++) {
                    sampler.sample(sample);
                    double dx = -3 + 6 * ((x + sampler.filmX()) / width);
                    double dy = 2 - 3 * ((y + sampler.filmY()) / height);
                    double dz = 3;
                    double scale = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
                    follow(0, 1, -3, dx * scale, dy * scale, dz * scale);
                    sum += green;
                }
            }
        }
        return sum / ((double) width * height * samples);
    }

    /** One path from the eye, as a whole loop over local variables. */
    private void follow(double eyeX, double eyeY, double eyeZ, double firstX, double firstY, double firstZ) {
        double ox = eyeX;
        double oy = eyeY;
        double oz = eyeZ;
        double dx = firstX;
        double dy = firstY;
        double dz = firstZ;
        double throughRed = 1;
        double throughGreen = 1;
        double throughBlue = 1;
        int from = NOTHING;
        boolean hasSampledLamp = false;
        red = 0;
        green = 0;
        blue = 0;
        for (int vertex = 0; ; vertex++) {
            int hit = intersect(ox, oy, oz, dx, dy, dz, from, vertex == 0);
            if (hit == NOTHING) {
                return;
            }
            if (hit == LAMP) {
                if (!hasSampledLamp) {
                    red = Math.fma(throughRed, RADIANCE, red);
                    green = Math.fma(throughGreen, RADIANCE, green);
                    blue = Math.fma(throughBlue, RADIANCE, blue);
                }
                return;
            }
            double x = Math.fma(distance, dx, ox);
            double y = Math.fma(distance, dy, oy);
            double z = Math.fma(distance, dz, oz);
            double nx = 0;
            double ny = 0;
            double nz = 0;
            switch (hit) {
                case LEFT -> {
                    nx = 1;
                    x = -HALF_WIDTH;
                }
                case RIGHT -> {
                    nx = -1;
                    x = HALF_WIDTH;
                }
                case FLOOR -> {
                    ny = 1;
                    y = -HALF_WIDTH;
                }
                case CEILING -> {
                    ny = -1;
                    y = HALF_WIDTH;
                }
                case BACK -> {
                    nz = -1;
                    z = DEPTH;
                }
                default -> {
                    double rx = x - CENTER_X[hit];
                    double ry = y - CENTER_Y[hit];
                    double rz = z - CENTER_Z[hit];
                    double scale = 1 / Math.sqrt(rx * rx + ry * ry + rz * rz);
                    nx = rx * scale;
                    ny = ry * scale;
                    nz = rz * scale;
                    x = CENTER_X[hit] + RADIUS[hit] * nx;
                    y = CENTER_Y[hit] + RADIUS[hit] * ny;
                    z = CENTER_Z[hit] + RADIUS[hit] * nz;
                }
            }
            throughRed *= RED[hit];
            throughGreen *= GREEN[hit];
            throughBlue *= BLUE[hit];
            hasSampledLamp = hit != MIRROR;
            if (hasSampledLamp) {
                double share = lampShare(x, y, z, nx, ny, nz, hit, vertex);
                red = Math.fma(throughRed, share, red);
                green = Math.fma(throughGreen, share, green);
                blue = Math.fma(throughBlue, share, blue);
                sampler.pair(vertex, Sampler.Purpose.DIRECTION, pair);
                Warp.toDisk(pair[0], pair[1], disk);
                basis.around(nx, ny, nz);
                double up = Math.sqrt(Math.max(1 - disk[2], 0));
                dx = disk[0] * basis.ax + disk[1] * basis.bx + up * nx;
                dy = disk[0] * basis.ay + disk[1] * basis.by + up * ny;
                dz = disk[0] * basis.az + disk[1] * basis.bz + up * nz;
            } else {
                double twice = 2 * (dx * nx + dy * ny + dz * nz);
                dx -= twice * nx;
                dy -= twice * ny;
                dz -= twice * nz;
            }
            double most = Math.max(throughRed, Math.max(throughGreen, throughBlue));
            if (vertex + 1 >= FIRST_ROULETTE || most < FAINT) {
                double survival = Math.min(LIKELIEST_TO_GO_ON, Math.max(RED[hit], Math.max(GREEN[hit], BLUE[hit])));
                if (sampler.unit(vertex + 1, Sampler.Purpose.ROULETTE) >= survival) {
                    return;
                }
                throughRed /= survival;
                throughGreen /= survival;
                throughBlue /= survival;
            }
            ox = x;
            oy = y;
            oz = z;
            from = hit;
        }
    }

    /** Which surface a ray meets first, or {@link #NOTHING}. Rays begin inside the room but for those of the camera, in front of it. */
    private int intersect(
            double ox, double oy, double oz, double dx, double dy, double dz, int from, boolean isCamera) {
        double nearest = Double.POSITIVE_INFINITY;
        int hit = NOTHING;
        for (int k = 0; k < BALLS; k++) {
            double t = k == from
                    ? Double.POSITIVE_INFINITY
                    : toSphere(ox, oy, oz, dx, dy, dz, CENTER_X[k], CENTER_Y[k], CENTER_Z[k], RADIUS[k]);
            if (t < nearest) {
                nearest = t;
                hit = k;
            }
        }
        double toLamp = toSphere(ox, oy, oz, dx, dy, dz, LAMP_X, LAMP_Y, LAMP_Z, LAMP_RADIUS);
        if (toLamp < nearest) {
            nearest = toLamp;
            hit = LAMP;
        }
        double tx = ((dx > 0 ? HALF_WIDTH : -HALF_WIDTH) - ox) / dx;
        double ty = ((dy > 0 ? HALF_WIDTH : -HALF_WIDTH) - oy) / dy;
        double tz = ((dz > 0 || isCamera ? DEPTH : FRONT) - oz) / dz;
        double wall = Math.min(tx, Math.min(ty, tz));
        if (wall < nearest) {
            nearest = wall;
            hit = wallOf(wall == tx, wall == ty, dx > 0, dy > 0, dz > 0);
        }
        distance = nearest;
        return hit;
    }

    private static int wallOf(boolean isSide, boolean isFlat, boolean toRight, boolean upward, boolean inward) {
        if (isSide) {
            return toRight ? RIGHT : LEFT;
        }
        if (isFlat) {
            return upward ? CEILING : FLOOR;
        }
        return inward ? BACK : NOTHING;
    }

    /** The distance to a sphere from outside, or infinity. */
    private static double toSphere(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double centerX,
            double centerY,
            double centerZ,
            double radius) {
        double x = centerX - ox;
        double y = centerY - oy;
        double z = centerZ - oz;
        double along = x * dx + y * dy + z * dz;
        double discriminant = along * along - (x * x + y * y + z * z - radius * radius);
        return discriminant > 0 && along > 0 ? along - Math.sqrt(discriminant) : Double.POSITIVE_INFINITY;
    }

    /** What a surface of albedo 1 sends out of the lamp's light: its irradiance in closed form, over π, where nothing can be in the way. */
    private double lampShare(double x, double y, double z, double nx, double ny, double nz, int from, int vertex) {
        double wx = LAMP_X - x;
        double wy = LAMP_Y - y;
        double wz = LAMP_Z - z;
        double squared = wx * wx + wy * wy + wz * wz;
        double height = nx * wx + ny * wy + nz * wz;
        if (height <= -LAMP_RADIUS) {
            return 0;
        }
        double away = Math.sqrt(squared);
        double scale = 1 / away;
        wx *= scale;
        wy *= scale;
        wz *= scale;
        int seen = seen(x, y, z, wx, wy, wz, away, from);
        if (seen == NONE_OF_IT || seen == PERHAPS && isSampleHidden(x, y, z, wx, wy, wz, from, vertex)) {
            return 0;
        }
        double cosine = height * scale;
        double whole = cosine * LAMP_RADIUS * LAMP_RADIUS / squared;
        return RADIANCE * (height >= LAMP_RADIUS ? whole : cut(cosine, away / LAMP_RADIUS) / Math.PI);
    }

    /** How much of the lamp the balls leave, by the cone around it. */
    private static int seen(double x, double y, double z, double wx, double wy, double wz, double away, int from) {
        int seen = ALL_OF_IT;
        double slope = LAMP_RADIUS / away;
        for (int k = 0; k < BALLS; k++) {
            if (k == from) {
                continue;
            }
            double cx = CENTER_X[k] - x;
            double cy = CENTER_Y[k] - y;
            double cz = CENTER_Z[k] - z;
            double along = cx * wx + cy * wy + cz * wz;
            if (along <= -RADIUS[k] || along >= away + RADIUS[k]) {
                continue;
            }
            double beside = cx * cx + cy * cy + cz * cz - along * along;
            double outer = RADIUS[k] + slope * along;
            if (beside >= outer * outer * 1.02) {
                continue;
            }
            double inner = RADIUS[k] - slope * along;
            if (inner > 0 && along > 0 && along < away && beside < inner * inner * 0.98) {
                return NONE_OF_IT;
            }
            seen = PERHAPS;
        }
        return seen;
    }

    /** A shadow ray to a point of the disk in which the lamp is seen. */
    private boolean isSampleHidden(
            double x, double y, double z, double wx, double wy, double wz, int from, int vertex) {
        sampler.pair(vertex, Sampler.Purpose.LIGHT, pair);
        Warp.toDisk(pair[0], pair[1], disk);
        basis.around(wx, wy, wz);
        double px = LAMP_X + LAMP_RADIUS * (disk[0] * basis.ax + disk[1] * basis.bx) - x;
        double py = LAMP_Y + LAMP_RADIUS * (disk[0] * basis.ay + disk[1] * basis.by) - y;
        double pz = LAMP_Z + LAMP_RADIUS * (disk[0] * basis.az + disk[1] * basis.bz) - z;
        double length = Math.sqrt(px * px + py * py + pz * pz);
        double scale = 1 / length;
        for (int k = 0; k < BALLS; k++) {
            if (k != from
                    && toSphere(
                                    x,
                                    y,
                                    z,
                                    px * scale,
                                    py * scale,
                                    pz * scale,
                                    CENTER_X[k],
                                    CENTER_Y[k],
                                    CENTER_Z[k],
                                    RADIUS[k])
                            < length) {
                return true;
            }
        }
        return false;
    }

    /** Irradiance of a sphere of radiance 1 that the horizon cuts; the cosine of its centre, the distance in radii. */
    private static double cut(double cosine, double radii) {
        double x = Math.sqrt(radii * radii - 1);
        double sine = Math.sqrt(1 - cosine * cosine);
        double y = -x * cosine / sine;
        if (y >= 1 || y <= -1) {
            return 0;
        }
        double q = sine * Math.sqrt(Math.max(0, 1 - y * y));
        return (cosine * Math.acos(y) - x * q) / (radii * radii) + Math.atan(q / x);
    }
}

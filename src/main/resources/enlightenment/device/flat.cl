// Spheres and flat shapes: primitive.SpherePrimitive, Plane, RectanglePrimitive, TrianglePrimitive and DiskPrimitive. Numbers of each are
// those of its flatForm.

// Sphere: centre, radius, meridian x and z.
double nearSphere(const Ray *r, double fx, double fy, double fz, double radius, double b, double s) {
    return b > 0 && s > b * 0.75 ? distanceSquaredMinus(fx, fy, fz, radius) / (b + s) : (b - s) / r->dd;
}

double nearestSphere(__global const double *q, const Ray *r, bool own, double tMax) {
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    double radius = q[3];
    double mx = difference(fy, r->dz, fz, r->dy);
    double my = difference(fz, r->dx, fx, r->dz);
    double mz = difference(fx, r->dy, fy, r->dx);
    double discriminant = radius * radius * r->dd - (mx * mx + my * my + mz * mz);
    double b = -(fx * r->dx + fy * r->dy + fz * r->dz);
    if (own) {
        if (r->startSide == OUTSIDE) {
            return MISS;
        }
        double t = larger((b + sqrt(larger(discriminant, 0))) / r->dd, r->tMin);
        return t <= tMax ? t : MISS;
    }
    if (!(discriminant >= 0)) {
        return MISS;
    }
    double s = sqrt(discriminant);
    double near = nearSphere(r, fx, fy, fz, radius, b, s);
    double far = b < 0 && s > -b * 0.75 ? distanceSquaredMinus(fx, fy, fz, radius) / (b - s) : (b + s) / r->dd;
    double t = near >= r->tMin ? near : far;
    return t >= r->tMin && t <= tMax ? t : MISS;
}

void completeSphere(__global const double *q, const Ray *r, bool own, Hit *hit) {
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    double radius = q[3];
    double mx = difference(fy, r->dz, fz, r->dy);
    double my = difference(fz, r->dx, fx, r->dz);
    double mz = difference(fx, r->dy, fy, r->dx);
    double discriminant = larger(radius * radius * r->dd - (mx * mx + my * my + mz * mz), 0);
    double b = -(fx * r->dx + fy * r->dy + fz * r->dz);
    double s = sqrt(discriminant);
    bool entering = !own && nearSphere(r, fx, fy, fz, radius, b, s) >= r->tMin;
    double halfOf = (entering ? -s : s) / r->dd;
    double vx = fma(halfOf, r->dx, difference(r->dy, mz, r->dz, my) / r->dd);
    double vy = fma(halfOf, r->dy, difference(r->dz, mx, r->dx, mz) / r->dd);
    double vz = fma(halfOf, r->dz, difference(r->dx, my, r->dy, mx) / r->dd);
    setNormal(hit, vx, vy, vz);
    hit->p = vec(fma(radius, hit->n.x, q[0]), fma(radius, hit->n.y, q[1]), fma(radius, hit->n.z, q[2]));
    hit->side = entering ? OUTSIDE : INSIDE;
    hit->face = 0;
}

// Plane: a, n, n², toU, toV, axis, coordinate, unit normal.
#define PLANE_SIZE 18

double distanceToPlane(__global const double *q, const Ray *r) {
    double axis = q[13];
    if (axis == 0) {
        return (q[14] - r->ox) / r->dx;
    }
    if (axis == 1) {
        return (q[14] - r->oy) / r->dy;
    }
    if (axis == 2) {
        return (q[14] - r->oz) / r->dz;
    }
    return accurateDot(q[3], q[4], q[5], q[0] - r->ox, q[1] - r->oy, q[2] - r->oz)
            / accurateDot(q[3], q[4], q[5], r->dx, r->dy, r->dz);
}

void completePlane(__global const double *q, const Ray *r, double t, Hit *hit) {
    double x = fma(t, r->dx, r->ox);
    double y = fma(t, r->dy, r->oy);
    double z = fma(t, r->dz, r->oz);
    double axis = q[13];
    double towards;
    if (axis < 0) {
        double off = accurateDot(q[3], q[4], q[5], x - q[0], y - q[1], z - q[2]) / q[6];
        hit->p = vec(fma(-off, q[3], x), fma(-off, q[4], y), fma(-off, q[5], z));
        setNormal(hit, q[3], q[4], q[5]);
        towards = accurateDot(q[3], q[4], q[5], r->dx, r->dy, r->dz);
    } else {
        hit->p = vec(axis == 0 ? q[14] : x, axis == 1 ? q[14] : y, axis == 2 ? q[14] : z);
        hit->n = vec(q[15], q[16], q[17]);
        towards = q[15] * r->dx + q[16] * r->dy + q[17] * r->dz;
    }
    hit->side = towards < 0 ? OUTSIDE : INSIDE;
    hit->face = 0;
}

void placeOnPlane(__global const double *q, const Hit *hit, double *uv) {
    double x = hit->p.x - q[0];
    double y = hit->p.y - q[1];
    double z = hit->p.z - q[2];
    uv[0] = clamp01(fusedDot(q[7], q[8], q[9], x, y, z));
    uv[1] = clamp01(1 - fusedDot(q[10], q[11], q[12], x, y, z));
}

// Rectangle: its plane, four corners, the axis that it is across, its extent on the two others, and its largest coordinate.
double nearestByEdges(__global const double *q, Ray *r, double planeDistance, double tMax) {
    shear(r);
    Vec a = vecAt(q + PLANE_SIZE);
    Vec b = vecAt(q + PLANE_SIZE + 3);
    Vec c = vecAt(q + PLANE_SIZE + 6);
    Vec d = vecAt(q + PLANE_SIZE + 9);
    double ax = shearedX(r, a);
    double ay = shearedY(r, a);
    double bx = shearedX(r, b);
    double by = shearedY(r, b);
    double cx = shearedX(r, c);
    double cy = shearedY(r, c);
    double px = shearedX(r, d);
    double py = shearedY(r, d);
    double ab = difference(ax, by, ay, bx);
    double bc = difference(bx, cy, by, cx);
    double cd = difference(cx, py, cy, px);
    double da = difference(px, ay, py, ax);
    double ac = difference(ax, cy, ay, cx);
    double t;
    if (covers(ab, bc, -ac)) {
        t = settled(r, planeDistance, a, b, c, ab, bc, -ac);
    } else if (covers(ac, cd, da)) {
        t = settled(r, planeDistance, a, c, d, ac, cd, da);
    } else {
        return MISS;
    }
    return t <= tMax ? t : MISS;
}

double greater(double a, double b) {
    return a > b ? a : b;
}

#define QUICK_TEST_ERROR GAMMA(64)

double nearestAligned(__global const double *q, Ray *r, double o1, double d1, double o2, double d2, double gap, double across, double tMax) {
    __global const double *e = q + PLANE_SIZE + 13;
    double slope = fabs(across);
    if (slope == 0) {
        return MISS;
    }
    double width = QUICK_TEST_ERROR * (fabs(r->ox) + fabs(r->oy) + fabs(r->oz) + e[4]);
    double ahead = across > 0 ? gap : -gap;
    double behind = r->tMin < 0 ? r->tMin * slope * (1 + QUICK_TEST_ERROR) : 0;
    if (ahead < behind - 2 * width || ahead > fma(tMax, slope * (1 + QUICK_TEST_ERROR), 2 * width)) {
        return MISS;
    }
    double t = gap / across;
    double early = greater(r->tMin - t, t - tMax);
    if (early * slope > width) {
        return MISS;
    }
    double p1 = fma(t, d1, o1);
    double p2 = fma(t, d2, o2);
    double outside = greater(greater(e[0] - p1, p1 - e[1]), greater(e[2] - p2, p2 - e[3]));
    double slanted = width * (slope + fabs(d1) + fabs(d2));
    if (outside * slope > slanted) {
        return MISS;
    }
    if (outside * slope < -slanted) {
        return early <= 0 ? t : MISS;
    }
    return nearestByEdges(q, r, t, tMax);
}

double nearestRectangle(__global const double *q, Ray *r, bool own, double tMax) {
    if (own) {
        return MISS;
    }
    double axis = q[PLANE_SIZE + 12];
    if (axis == 2) {
        return nearestAligned(q, r, r->ox, r->dx, r->oy, r->dy, q[14] - r->oz, r->dz, tMax);
    }
    if (axis == 1) {
        return nearestAligned(q, r, r->ox, r->dx, r->oz, r->dz, q[14] - r->oy, r->dy, tMax);
    }
    if (axis == 0) {
        return nearestAligned(q, r, r->oy, r->dy, r->oz, r->dz, q[14] - r->ox, r->dx, tMax);
    }
    return nearestByEdges(q, r, distanceToPlane(q, r), tMax);
}

// Triangle: its plane, three corners, whether these have texture coordinates, and these: u and v of each.
double nearestTriangle(__global const double *q, Ray *r, bool own, double tMax) {
    if (own) {
        return MISS;
    }
    shear(r);
    Vec a = vecAt(q + PLANE_SIZE);
    Vec b = vecAt(q + PLANE_SIZE + 3);
    Vec c = vecAt(q + PLANE_SIZE + 6);
    double ax = shearedX(r, a);
    double ay = shearedY(r, a);
    double bx = shearedX(r, b);
    double by = shearedY(r, b);
    double cx = shearedX(r, c);
    double cy = shearedY(r, c);
    double e0 = difference(ax, by, ay, bx);
    double e1 = difference(bx, cy, by, cx);
    double e2 = difference(cx, ay, cy, ax);
    if (!covers(e0, e1, e2)) {
        return MISS;
    }
    double t = settled(r, distanceToPlane(q, r), a, b, c, e0, e1, e2);
    return t <= tMax ? t : MISS;
}

// Disk: centre, normal, unit normal, radius, the axis that the normal is parallel to, right and up of the texture.
double nearestDisk(__global const double *q, const Ray *r, bool own, double tMax) {
    if (own) {
        return MISS;
    }
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    double e = accurateDot(q[3], q[4], q[5], r->dx, r->dy, r->dz);
    double aligned = q[10];
    double t = aligned == 0 ? (q[0] - r->ox) / r->dx
            : aligned == 1  ? (q[1] - r->oy) / r->dy
            : aligned == 2  ? (q[2] - r->oz) / r->dz
                            : -accurateDot(q[3], q[4], q[5], fx, fy, fz) / e;
    if (!(t >= r->tMin && t <= tMax) || e == 0) {
        return MISS;
    }
    double mx = difference(fy, r->dz, fz, r->dy);
    double my = difference(fz, r->dx, fx, r->dz);
    double mz = difference(fx, r->dy, fy, r->dx);
    double vx = difference(q[4], mz, q[5], my);
    double vy = difference(q[5], mx, q[3], mz);
    double vz = difference(q[3], my, q[4], mx);
    double rim = q[9] * e;
    return vx * vx + vy * vy + vz * vz <= rim * rim ? t : MISS;
}

void completeDisk(__global const double *q, const Ray *r, Hit *hit) {
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    double e = accurateDot(q[3], q[4], q[5], r->dx, r->dy, r->dz);
    double mx = difference(fy, r->dz, fz, r->dy);
    double my = difference(fz, r->dx, fx, r->dz);
    double mz = difference(fx, r->dy, fy, r->dx);
    hit->p = vec(q[0] + difference(q[4], mz, q[5], my) / e, q[1] + difference(q[5], mx, q[3], mz) / e,
            q[2] + difference(q[3], my, q[4], mx) / e);
    hit->n = vec(q[6], q[7], q[8]);
    hit->side = e < 0 ? OUTSIDE : INSIDE;
    hit->face = 0;
}

// Cylinders and cones: primitive.LateralInterval, AxialPrimitive, AxialSurface, CylinderPrimitive and ConePrimitive. Numbers: reference
// point, axis A, its unit, length, extent, narrow and wide radius, slope, reach², narrow is top, aligned axis, axis, unit axis, capped, is a
// cone, r², r|A|, n/|A|, n|A|, tilt across and along, seam, east, base, top and their radii.
#define UNIT 6
#define LENGTH 7
#define EXTENT 8
#define NARROW 9
#define WIDE 10
#define SLOPE 11
#define REACH_SQUARED 12
#define NARROW_IS_TOP 13
#define ALIGNED 14
#define AXIS 15
#define UNIT_AXIS 18
#define CAPPED 21
#define IS_CONE 22
#define RADIUS_SQUARED 23
#define RADIUS_LENGTH 24
#define NARROW_OVER_LENGTH 25
#define NARROW_TIMES_LENGTH 26
#define TILT_ACROSS 27
#define TILT_ALONG 28
#define SEAM 29
#define EAST 32
#define BASE_CENTER 35
#define TOP_CENTER 38
#define BASE_RADIUS 41
#define TOP_RADIUS 42

#define LATERAL 0
#define BASE 1
#define TOP 2

double axialMoment(double m1, double m2, double m3, double f1, double f2, double f3) {
    double boundM = fabs(m1) + fabs(m2) + fabs(m3);
    double boundF = fabs(f1) + fabs(f2) + fabs(f3);
    return boundM <= 2 * boundF ? m1 + m2 + m3 : f1 + f2 + f3;
}

double lowerEnd(double a, double b, double c, double s, double e) {
    double q = b > 0 ? -b - s : -b + s;
    if (a < 0) {
        return e < 0 ? -INFINITY : q == 0 ? 0 : larger(q / a, c / q);
    }
    if (q == 0) {
        return a > 0 ? 0 : c > 0 ? INFINITY : -INFINITY;
    }
    return b > 0 ? q / a : c / q;
}

double upperEnd(double a, double b, double c, double s, double e) {
    double q = b > 0 ? -b - s : -b + s;
    if (a < 0) {
        return e > 0 ? INFINITY : q == 0 ? 0 : smaller(q / a, c / q);
    }
    if (q == 0) {
        return a > 0 ? 0 : c > 0 ? -INFINITY : INFINITY;
    }
    return b > 0 ? c / q : q / a;
}

double foundAxial(Hit *hit, double t, double tMax, double along, int side, int face) {
    if (!(t <= tMax)) {
        return MISS;
    }
    hit->weightB = along;
    hit->side = side;
    hit->face = face;
    return t;
}

double endParameter(__global const double *q, const Ray *r, double t, bool narrow) {
    double aligned = q[ALIGNED];
    if (aligned < 0) {
        return t;
    }
    int k = (int) aligned;
    double at = narrow ? q[k] : q[(q[NARROW_IS_TOP] != 0 ? BASE_CENTER : TOP_CENTER) + k];
    return (at - originOf(r, k)) / directionOf(r, k);
}

int endFace(__global const double *q, bool narrow) {
    return narrow == (q[NARROW_IS_TOP] != 0) ? TOP : BASE;
}

double cutOpen(const Ray *r, bool started, double tMax, Hit *hit, double foot, double lo, double hi, double near, double far) {
    if (!started && lo >= near && lo <= far && lo <= hi && foot + lo >= r->tMin) {
        return foundAxial(hit, foot + lo, tMax, lo, OUTSIDE, LATERAL);
    }
    double exit = started ? larger(hi, r->tMin - foot) : hi;
    if (exit >= near && exit <= far && (started || lo <= hi) && (started || foot + exit >= r->tMin)) {
        return foundAxial(hit, larger(foot + exit, r->tMin), tMax, exit, INSIDE, LATERAL);
    }
    return MISS;
}

double cutAxial(__global const double *q, const Ray *r, bool started, double tMax, Hit *hit, double foot, double lo, double hi, double h,
        double e) {
    double near = -INFINITY;
    double far = INFINITY;
    double extent = q[EXTENT];
    if (e > 0) {
        near = -h / e;
        far = (extent - h) / e;
    } else if (e < 0) {
        near = (extent - h) / e;
        far = -h / e;
    } else if (!started && !(h >= 0 && h <= extent)) {
        return MISS;
    }
    if (q[CAPPED] == 0) {
        return cutOpen(r, started, tMax, hit, foot, lo, hi, near, far);
    }
    if (!started) {
        bool lateral = lo >= near;
        if (!((lateral ? lo : near) <= smaller(hi, far))) {
            return MISS;
        }
        double t = lateral ? foot + lo : endParameter(q, r, foot + near, e > 0);
        if (t >= r->tMin) {
            return foundAxial(hit, t, tMax, lateral ? lo : NAN, OUTSIDE, lateral ? LATERAL : endFace(q, e > 0));
        }
    }
    bool lateral = hi <= far;
    double t = lateral ? foot + hi : endParameter(q, r, foot + far, e < 0);
    double along = lateral ? hi : NAN;
    if (started && !(t >= r->tMin)) {
        t = r->tMin;
        along = t - foot;
    }
    return t >= r->tMin ? foundAxial(hit, t, tMax, along, INSIDE, lateral ? LATERAL : endFace(q, e < 0)) : MISS;
}

double coneDiscriminant(__global const double *q, double moment, Vec m, Vec u) {
    double qx = fma(q[SLOPE], m.x, -q[NARROW_OVER_LENGTH] * u.x);
    double qy = fma(q[SLOPE], m.y, -q[NARROW_OVER_LENGTH] * u.y);
    double qz = fma(q[SLOPE], m.z, -q[NARROW_OVER_LENGTH] * u.z);
    double vx = difference(q[4], qz, q[5], qy);
    double vy = difference(q[5], qx, q[3], qz);
    double vz = difference(q[3], qy, q[4], qx);
    return fma(-moment, moment, vx * vx + vy * vy + vz * vz);
}

bool meetsWideDisk(__global const double *q, Vec m, Vec u, double e) {
    double kx = fma(q[UNIT], u.x, m.x);
    double ky = fma(q[UNIT], u.y, m.y);
    double kz = fma(q[UNIT], u.z, m.z);
    double vx = difference(q[4], kz, q[5], ky);
    double vy = difference(q[5], kx, q[3], kz);
    double vz = difference(q[3], ky, q[4], kx);
    double rim = q[WIDE] * e;
    return vx * vx + vy * vy + vz * vz <= rim * rim;
}

// Sets side, face and weightB (where along the line it is) of the crossing.
double crossingAxial(__global const double *q, const Ray *r, bool started, double tMax, Hit *hit) {
    if (started && r->startSide == OUTSIDE) {
        return MISS;
    }
    bool isCone = q[IS_CONE] != 0;
    double dx = r->dx;
    double dy = r->dy;
    double dz = r->dz;
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    Vec m = vec(difference(fy, dz, fz, dy), difference(fz, dx, fx, dz), difference(fx, dy, fy, dx));
    if (!started && m.x * m.x + m.y * m.y + m.z * m.z > q[REACH_SQUARED] * r->dd) {
        return MISS;
    }
    double inv = 1 / r->dd;
    double px = difference(dy, m.z, dz, m.y) * inv;
    double py = difference(dz, m.x, dx, m.z) * inv;
    double pz = difference(dx, m.y, dy, m.x) * inv;
    Vec u = vec(difference(dy, q[5], dz, q[4]), difference(dz, q[3], dx, q[5]), difference(dx, q[4], dy, q[3]));
    double uu = u.x * u.x + u.y * u.y + u.z * u.z;
    double h = fusedDot(px, py, pz, q[3], q[4], q[5]);
    double e = fusedDot(dx, dy, dz, q[3], q[4], q[5]);
    double widening = q[SLOPE] * e;
    double a = isCone ? uu - widening * widening : uu;
    double moment = axialMoment(m.x * q[3], m.y * q[4], m.z * q[5], px * u.x, py * u.y, pz * u.z);
    double discriminant = isCone ? coneDiscriminant(q, moment, m, u) : difference(q[RADIUS_SQUARED], uu, moment, moment);
    if (!(discriminant >= 0)) {
        if (!started && (!isCone || a > 0)) {
            return MISS;
        }
        discriminant = 0;
    }
    double wx = difference(py, q[5], pz, q[4]);
    double wy = difference(pz, q[3], px, q[5]);
    double wz = difference(px, q[4], py, q[3]);
    double radius = isCone ? fma(q[SLOPE], h, q[NARROW_TIMES_LENGTH]) : q[RADIUS_LENGTH];
    double b = wx * u.x + wy * u.y + wz * u.z;
    b = isCone ? b - widening * radius : b;
    double c = distanceSquaredMinus(wx, wy, wz, radius);
    double s = q[LENGTH] * sqrt(discriminant);
    double foot = -(fx * dx + fy * dy + fz * dz) * inv;
    double lo = lowerEnd(a, b, c, s, e);
    double hi = upperEnd(a, b, c, s, e);
    if (isCone && q[SLOPE] > 1 && a < 0 && q[CAPPED] != 0) {
        if (!meetsWideDisk(q, m, u, e) && !started) {
            return MISS;
        }
        double toWide = (q[EXTENT] - h) / e;
        lo = e > 0 ? smaller(lo, toWide) : lo;
        hi = e < 0 ? larger(hi, toWide) : hi;
    }
    return cutAxial(q, r, started, tMax, hit, foot, lo, hi, h, e);
}

void completeLateral(__global const double *q, const Ray *r, Vec m, Hit *hit) {
    double along = hit->weightB;
    double px = fma(along, r->dx, difference(r->dy, m.z, r->dz, m.y) / r->dd);
    double py = fma(along, r->dy, difference(r->dz, m.x, r->dx, m.z) / r->dd);
    double pz = fma(along, r->dz, difference(r->dx, m.y, r->dy, m.x) / r->dd);
    Vec e = vecAt(q + UNIT_AXIS);
    double wx = difference(py, e.z, pz, e.y);
    double wy = difference(pz, e.x, px, e.z);
    double wz = difference(px, e.y, py, e.x);
    double radial = sqrt(wx * wx + wy * wy + wz * wz);
    double fraction = q[SLOPE] > 1 ? (radial - q[NARROW]) / (q[WIDE] - q[NARROW]) : fusedDot(px, py, pz, q[3], q[4], q[5]) / q[EXTENT];
    fraction = clamp01(fraction);
    double radius = fma(q[WIDE] - q[NARROW], fraction, q[NARROW]);
    if (radial > 0) {
        setNormal(hit, difference(e.y, wz, e.z, wy), difference(e.z, wx, e.x, wz), difference(e.x, wy, e.y, wx));
    } else {
        setNormal(hit, q[SEAM], q[SEAM + 1], q[SEAM + 2]);
    }
    hit->p = vec(fma(radius, hit->n.x, fma(fraction, q[AXIS], q[0])), fma(radius, hit->n.y, fma(fraction, q[AXIS + 1], q[1])),
            fma(radius, hit->n.z, fma(fraction, q[AXIS + 2], q[2])));
    double tilt = q[TILT_ALONG];
    if (tilt > 0) {
        setNormal(hit, fma(q[TILT_ACROSS], hit->n.x, -tilt * e.x), fma(q[TILT_ACROSS], hit->n.y, -tilt * e.y),
                fma(q[TILT_ACROSS], hit->n.z, -tilt * e.z));
    }
}

void completeEnd(__global const double *q, const Ray *r, Vec m, Hit *hit) {
    bool narrowIsTop = q[NARROW_IS_TOP] != 0;
    bool narrow = (hit->face == TOP) == narrowIsTop;
    double sign = narrow ? -1 : 1;
    Vec axis = vecAt(q + UNIT_AXIS);
    hit->n = vec(sign * axis.x, sign * axis.y, sign * axis.z);
    Vec center = narrow ? vecAt(q) : vecAt(q + (narrowIsTop ? BASE_CENTER : TOP_CENTER));
    if (hit->weightB == hit->weightB) {
        double x = r->ox - center.x;
        double y = r->oy - center.y;
        double z = r->oz - center.z;
        double off = fusedDot(x, y, z, axis.x, axis.y, axis.z);
        hit->p = vec(center.x + (x - axis.x * off), center.y + (y - axis.y * off), center.z + (z - axis.z * off));
        return;
    }
    double e = fusedDot(r->dx, r->dy, r->dz, q[3], q[4], q[5]);
    double kx = narrow ? m.x : fma(q[UNIT], difference(r->dy, q[5], r->dz, q[4]), m.x);
    double ky = narrow ? m.y : fma(q[UNIT], difference(r->dz, q[3], r->dx, q[5]), m.y);
    double kz = narrow ? m.z : fma(q[UNIT], difference(r->dx, q[4], r->dy, q[3]), m.z);
    hit->p = vec(center.x + difference(q[4], kz, q[5], ky) / e, center.y + difference(q[5], kx, q[3], kz) / e,
            center.z + difference(q[3], ky, q[4], kx) / e);
}

void completeAxial(__global const double *q, const Ray *r, bool own, Hit *hit) {
    crossingAxial(q, r, own, DBL_MAX, hit);
    double fx = r->ox - q[0];
    double fy = r->oy - q[1];
    double fz = r->oz - q[2];
    Vec m = vec(difference(fy, r->dz, fz, r->dy), difference(fz, r->dx, fx, r->dz), difference(fx, r->dy, fy, r->dx));
    if (hit->face == LATERAL) {
        completeLateral(q, r, m, hit);
    } else {
        completeEnd(q, r, m, hit);
    }
}

// primitive.Disks.textureCoordinates
void placeOnDisk(Vec p, Vec right, Vec up, double radius, double *uv) {
    uv[0] = radius > 0 ? clamp01(0.5 + 0.5 * (fusedDot(p.x, p.y, p.z, right.x, right.y, right.z) / radius)) : 0.5;
    uv[1] = radius > 0 ? clamp01(0.5 - 0.5 * (fusedDot(p.x, p.y, p.z, up.x, up.y, up.z) / radius)) : 0.5;
}

void placeOnAxial(__global const double *q, const Hit *hit, double *uv) {
    Vec seam = vecAt(q + SEAM);
    Vec east = vecAt(q + EAST);
    if (hit->face != LATERAL) {
        bool atTop = hit->face == TOP;
        Vec c = vecAt(q + (atTop ? TOP_CENTER : BASE_CENTER));
        Vec p = vec(hit->p.x - c.x, hit->p.y - c.y, hit->p.z - c.z);
        placeOnDisk(p, east, atTop ? vec(-seam.x, -seam.y, -seam.z) : seam, q[atTop ? TOP_RADIUS : BASE_RADIUS], uv);
        return;
    }
    Vec b = vecAt(q + BASE_CENTER);
    Vec p = vec(hit->p.x - b.x, hit->p.y - b.y, hit->p.z - b.z);
    double turn = angleOf(fusedDot(p.x, p.y, p.z, east.x, east.y, east.z), fusedDot(p.x, p.y, p.z, seam.x, seam.y, seam.z)) / (2 * PI);
    uv[0] = turn < 0 ? turn + 1 : turn;
    double fraction = fusedDot(hit->p.x - q[0], hit->p.y - q[1], hit->p.z - q[2], q[3], q[4], q[5]) / q[EXTENT];
    uv[1] = clamp01(q[NARROW_IS_TOP] != 0 ? fraction : 1 - fraction);
}

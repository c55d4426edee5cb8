package enlightenment.classic.cluster;

import enlightenment.sampling.Distribution;
import enlightenment.sampling.Proposal;
import java.util.Arrays;

/**
 * One part of a cluster's proposal: where on the light's disk its points lie, as a linear function of the film position, and
 * how far around that they are spread, along the two principal axes of the spread.
 *
 * <p>Least squares of p and q over (1, x, y) with weights, by centred second moments; the slopes are damped as if one more
 * point of each axis had shown none. Variances are taken 1.25 times as great, since proposals that are too narrow cost more
 * than ones that are too wide.
 */
final class Lobe {
    private static final double WIDER = 1.25;

    /** Of the sums: 1, x, y, p, q, then the products of the last four, row by row. */
    private static final int SUMS = 15;

    private final double[] sums = new double[SUMS];
    private final Proposal first;
    private final Proposal second;
    private double finest;

    /** Middle on the film, middle on the disk and the slopes of p and q. */
    private double middleX;

    private double middleY;
    private double middleP;
    private double middleQ;
    private double pByX;
    private double pByY;
    private double qByX;
    private double qByY;

    /** Direction of the longer principal axis, and the deviations along it and across. */
    private double axisP = 1;

    private double axisQ;
    private double longer;
    private double shorter;

    /** The share of the mixture's lobes. */
    double share;

    /** The proposed place. */
    double p;

    double q;

    Lobe(Distribution family) {
        first = new Proposal(family);
        second = new Proposal(family);
    }

    /** Forgets everything; no deviation will be smaller than this one. */
    void clear(double finestDeviation) {
        finest = finestDeviation;
        forget();
    }

    /** Forgets the points, but not the fit. */
    void forget() {
        Arrays.fill(sums, 0);
    }

    void copyShape(Lobe other) {
        middleX = other.middleX;
        middleY = other.middleY;
        middleP = other.middleP;
        middleQ = other.middleQ;
        pByX = other.pByX;
        pByY = other.pByY;
        qByX = other.qByX;
        qByY = other.qByY;
        axisP = other.axisP;
        axisQ = other.axisQ;
        longer = other.longer;
        shorter = other.shorter;
    }

    /** Moves the middle along the longer axis. */
    void move(double by) {
        middleP += by * axisP;
        middleQ += by * axisQ;
    }

    double deviation() {
        return longer;
    }

    double weight() {
        return sums[0];
    }

    void add(double x, double y, double pp, double qq, double w) {
        double wx = w * x;
        double wy = w * y;
        double wp = w * pp;
        double[] s = sums;
        s[0] += w;
        s[1] += wx;
        s[2] += wy;
        s[3] += wp;
        s[4] += w * qq;
        s[5] += wx * x;
        s[6] += wx * y;
        s[7] += wx * pp;
        s[8] += wx * qq;
        s[9] += wy * y;
        s[10] += wy * pp;
        s[11] += wy * qq;
        s[12] += wp * pp;
        s[13] += wp * qq;
        s[14] += w * qq * qq;
    }

    /** Fits middle, slopes and spread to the points. */
    void fit() {
        double[] s = sums;
        double n = 1 / s[0];
        middleX = s[1] * n;
        middleY = s[2] * n;
        middleP = s[3] * n;
        middleQ = s[4] * n;
        // One more point of each axis, a pixel away, with no slope.
        double xx = s[5] * n - middleX * middleX + n;
        double xy = s[6] * n - middleX * middleY;
        double yy = s[9] * n - middleY * middleY + n;
        double xp = s[7] * n - middleX * middleP;
        double yp = s[10] * n - middleY * middleP;
        double xq = s[8] * n - middleX * middleQ;
        double yq = s[11] * n - middleY * middleQ;
        double inverse = 1 / (xx * yy - xy * xy);
        pByX = (yy * xp - xy * yp) * inverse;
        pByY = (xx * yp - xy * xp) * inverse;
        qByX = (yy * xq - xy * yq) * inverse;
        qByY = (xx * yq - xy * xq) * inverse;
        double pp = s[12] * n - middleP * middleP - pByX * xp - pByY * yp;
        double pq = s[13] * n - middleP * middleQ - pByX * xq - pByY * yq;
        double qq = s[14] * n - middleQ * middleQ - qByX * xq - qByY * yq;
        // Three numbers were fitted to the points, and a new point has the error of the fit on top of its own.
        double unseen = s[0] > 3 ? (s[0] + 3) / (s[0] - 3) : 1;
        principalAxes(unseen * pp, unseen * pq, unseen * qq);
    }

    /** Eigenvectors of ((pp, pq), (pq, qq)). */
    private void principalAxes(double pp, double pq, double qq) {
        double half = (pp - qq) / 2;
        double root = Math.sqrt(half * half + pq * pq);
        double middle = (pp + qq) / 2;
        double ax = half >= 0 ? half + root : pq;
        double ay = half >= 0 ? pq : root - half;
        double length = Math.sqrt(ax * ax + ay * ay);
        axisP = length > 0 ? ax / length : 1;
        axisQ = length > 0 ? ay / length : 0;
        longer = deviation(middle + root);
        shorter = deviation(middle - root);
    }

    private double deviation(double variance) {
        return Math.sqrt(Math.max(WIDER * variance, finest * finest));
    }

    /** Squared distance from the middle, in deviations, and what the lobe's size makes points less likely. */
    double distance(double x, double y, double pp, double qq) {
        double dp = pp - middleP - pByX * (x - middleX) - pByY * (y - middleY);
        double dq = qq - middleQ - qByX * (x - middleX) - qByY * (y - middleY);
        double along = (dp * axisP + dq * axisQ) / longer;
        double across = (dq * axisP - dp * axisQ) / shorter;
        return along * along + across * across;
    }

    /** Turns to a film position. */
    void aim(double x, double y) {
        double mp = middleP + pByX * (x - middleX) + pByY * (y - middleY);
        double mq = middleQ + qByX * (x - middleX) + qByY * (y - middleY);
        first.set(mp * axisP + mq * axisQ, longer, -1, 1);
        second.set(mq * axisP - mp * axisQ, shorter, -1, 1);
    }

    /** Chooses p and q: anywhere in the square around the disk that has the lobe's axes. */
    void propose(double u, double v) {
        double a = first.sample(u);
        double b = second.sample(v);
        p = a * axisP - b * axisQ;
        q = a * axisQ + b * axisP;
    }

    /** The density of a place in the square. */
    double density(double pp, double qq) {
        return first.density(pp * axisP + qq * axisQ) * second.density(qq * axisP - pp * axisQ);
    }
}

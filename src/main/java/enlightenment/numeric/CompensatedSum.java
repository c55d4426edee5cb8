package enlightenment.numeric;

/** A sum that loses next to nothing however many terms it has (Neumaier 1974). It depends on the order of its terms. */
public final class CompensatedSum {
    private double sum;
    private double lost;

    public CompensatedSum() {}

    public void add(double term) {
        double next = sum + term;
        lost += Math.abs(sum) >= Math.abs(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }

    public double value() {
        return sum + lost;
    }
}

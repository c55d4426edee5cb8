package enlightenment.accel;

import enlightenment.primitive.Ray;

/** Finds the first primitive that a ray hits. */
public interface RaySearch {
    /** Continues a search: offers to the state every primitive that could be closer than what it has. */
    void search(Ray ray, Closest state);
}

/** Binary trees of boxes, whatever lies in the boxes: how they are built and how rays are tested against them. */
package enlightenment.bvh;

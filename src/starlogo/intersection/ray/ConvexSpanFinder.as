package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds which part of a ray's line is inside of any convex structure. A point that moves along the line meets the structure where the line enters
     * it, and a point that moves back meets it where the line leaves it. For hulls, boxes and round structures SpanFinder has formulas, which are faster.
     *
     * @private
     */
    public final class ConvexSpanFinder
    {
        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _place:Vector3D = new Vector3D();
        private var _point:ConvexShape = new ConvexShape();
        private var _shape:ConvexShape = new ConvexShape();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _contact:ContactPoint = new ContactPoint();

        /**
         * Finds the part of the line inside of a structure, which is wider by the margin of its ConvexShape.
         *
         * @param ray in the space of the structure
         * @param structure convex
         * @param out receives the part
         * @return whether the line meets the structure
         */
        public function find(ray:Ray, structure:BoundingStructure, out:RaySpan):Boolean
        {
            structure.setShape(_shape);
            // the part of the line that may be inside
            var closestDistance:Number = (_shape.origin.x - ray.origin.x) * ray.direction.x + (_shape.origin.y - ray.origin.y) * ray.direction.y + (_shape.origin.z - ray.origin.z) * ray.direction.z;
            var reach:Number = 2 * (_shape.boundingRadius + _shape.radius) + Number.MIN_VALUE;
            var near:Number = meetFrom(ray, closestDistance - reach, 2 * reach);
            if (near == Infinity)
            {
                return false;
            }
            out.near.normal.setTo(_contact.normalX, _contact.normalY, _contact.normalZ);
            var far:Number = meetFrom(ray, closestDistance + reach, -2 * reach);
            out.far.normal.setTo(_contact.normalX, _contact.normalY, _contact.normalZ);
            out.setPlaces(near, far);
            return near <= far && far < Infinity;
        }

        // Where a point first meets the shape if it moves by a length from a place on the line, with the contact there. Infinity if it does not.
        private function meetFrom(ray:Ray, from:Number, length:Number):Number
        {
            _place.setTo(ray.origin.x + from * ray.direction.x, ray.origin.y + from * ray.direction.y, ray.origin.z + from * ray.direction.z);
            _point.setPoint(_place);
            _motion.x = length * ray.direction.x;
            _motion.y = length * ray.direction.y;
            _motion.z = length * ray.direction.z;
            _kernel.findTimeOfImpact(_point, _shape, _motion);
            if (_motion.time == RelativeMotion.NEVER)
            {
                return Infinity;
            }
            _kernel.findContact(_point, _shape, _motion, _contact);
            return from + length * _motion.time;
        }
    }
}

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
     * Finds where rays enter any convex structure. A point that moves along the ray meets the structure where the ray enters it, and a
     * point that moves back meets it where the ray leaves it. Hulls, boxes and round structures have faster functions.
     *
     * @private
     */
    public final class ConvexRay
    {
        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _place:Vector3D = new Vector3D();
        private var _point:ConvexShape = new ConvexShape();
        private var _shape:ConvexShape = new ConvexShape();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _contact:ContactPoint = new ContactPoint();

        /**
         * Finds where a ray enters a structure, which is wider by the margin of its ConvexShape.
         *
         * @param ray in the space of the structure
         * @param structure convex
         * @param out receives the distance and the normal
         * @return whether the ray meets the structure
         */
        public function enter(ray:Ray, structure:BoundingStructure, out:RayEntry):Boolean
        {
            structure.shapeInto(_shape);
            // the part of the line that may be inside
            var middle:Number = (_shape.x - ray.x) * ray.directionX + (_shape.y - ray.y) * ray.directionY + (_shape.z - ray.z) * ray.directionZ;
            var boundingRadius:Number = 2 * (_shape.extent + _shape.radius) + Number.MIN_VALUE;
            var start:Number = middle - boundingRadius;
            var end:Number = middle + boundingRadius;
            var length:Number = 2 * boundingRadius;
            var near:Number = start + length * timeFrom(ray, start, length);
            out.begin(ray);
            if (near > ray.from && near < Infinity)
            {
                _kernel.findContact(_point, _shape, _motion, _contact);
                out.distance = near;
                out.setNormal(ray, _contact.normalX, _contact.normalY, _contact.normalZ);
            }
            var far:Number = end - length * timeFrom(ray, end, -length);
            return near < Infinity && out.distance <= far && out.distance <= ray.to;
        }

        // When a point first meets the shape, if it moves by a length from a place on the ray.
        private function timeFrom(ray:Ray, from:Number, length:Number):Number
        {
            _place.setTo(ray.x + from * ray.directionX, ray.y + from * ray.directionY, ray.z + from * ray.directionZ);
            _point.setPoint(_place);
            _motion.x = length * ray.directionX;
            _motion.y = length * ray.directionY;
            _motion.z = length * ray.directionZ;
            _kernel.findTime(_point, _shape, _motion);
            return _motion.time;
        }
    }
}

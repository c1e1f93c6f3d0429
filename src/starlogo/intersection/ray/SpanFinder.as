// The package intersection.ray says where a ray meets a structure or a triangle. It is made of Ray, of SpanFinder for structures and ShearedRay for
// triangles, and of the records that they write. Read SpanFinder first.

package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Finds which part of a ray's line is inside of a structure. RayCrossing derives from it where the ray enters,
     * and RayCrossings where it enters and leaves. Each kind has a formula. Touching counts, to within a factor on the structure's extents, which is
     * Tolerances.TOUCHING. Nothing is allocated, except at the first ray that meets a hull where it is.
     *
     * @private
     */
    public final class SpanFinder
    {
        // The part of a line in the ball around an end of a capsule.
        private static const BALL:RaySpan = new RaySpan();

        /**
         * Finds the part of the line inside of a structure.
         *
         * @param ray in the space of the structure
         * @param structure a sphere, a capsule, a box, a hull, or another convex structure
         * @param convex answers for convex structures without half-spaces, which are further structures of the engine; null if there are none
         * @param out receives the part
         * @return whether the line meets the structure
         * @throws ArgumentError for any other structure
         */
        public static function find(ray:Ray, structure:BoundingStructure, convex:ConvexSpanFinder, out:RaySpan):Boolean
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    return findInSphere(ray, Sphere(structure), out);
                case BoundingStructure.CAPSULE:
                    return findInCapsule(ray, Capsule(structure), out);
                case BoundingStructure.BOX:
                    return findInBox(ray, Box(structure), Tolerances.TOUCHING, out);
                case BoundingStructure.HULL:
                    // "is Hull" would load Hull, and with it the search for convex hulls, into every game on the ES module that has rays. A type or a
                    // cast loads nothing.
                    if (structure.halfSpaces != null)
                    {
                        return findInHull(ray, Hull(structure), out);
                    }
                    if (convex != null)
                    {
                        return convex.find(ray, structure, out);
                    }
                    break;
            }
            throw new ArgumentError("there is no test of rays for " + structure);
        }

        private static function findInSphere(ray:Ray, sphere:Sphere, out:RaySpan):Boolean
        {
            return findInBall(ray, sphere.center, sphere.radius * Tolerances.TOUCHING, out);
        }

        private static function findInBall(ray:Ray, center:Vector3D, radius:Number, out:RaySpan):Boolean
        {
            var x:Number = ray.origin.x - center.x;
            var y:Number = ray.origin.y - center.y;
            var z:Number = ray.origin.z - center.z;
            // The middle of the part, and the vector to it from the centre. It is perpendicular to the line, so no digits cancel (Haines, Günther and
            // Akenine-Möller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, 2019).
            var closestDistance:Number = -(x * ray.direction.x + y * ray.direction.y + z * ray.direction.z);
            x += closestDistance * ray.direction.x;
            y += closestDistance * ray.direction.y;
            z += closestDistance * ray.direction.z;
            var halfSquared:Number = radius * radius - (x * x + y * y + z * z);
            if (!(halfSquared >= 0))
            {
                return false;
            }
            var half:Number = Math.sqrt(halfSquared);
            var halfX:Number = half * ray.direction.x;
            var halfY:Number = half * ray.direction.y;
            var halfZ:Number = half * ray.direction.z;
            out.setPlaces(closestDistance - half, closestDistance + half);
            out.near.normal.setTo(x - halfX, y - halfY, z - halfZ);
            out.far.normal.setTo(x + halfX, y + halfY, z + halfZ);
            return true;
        }

        // The line enters and leaves the capsule on the infinite cylinder around the axis or, where that is beyond an end of the axis, on the ball
        // around that end.
        private static function findInCapsule(ray:Ray, capsule:Capsule, out:RaySpan):Boolean
        {
            var radius:Number = capsule.radius * Tolerances.TOUCHING;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            var x:Number = ray.origin.x - start.x;
            var y:Number = ray.origin.y - start.y;
            var z:Number = ray.origin.z - start.z;
            // As fractions of the axis: the place of the line's point, and how far the line goes along the axis in a length of 1. What is left of the
            // direction is across the axis.
            var fraction:Number = squared > 0 ? (x * axisX + y * axisY + z * axisZ) / squared : 0;
            var speed:Number = squared > 0 ? (ray.direction.x * axisX + ray.direction.y * axisY + ray.direction.z * axisZ) / squared : 0;
            var acrossX:Number = ray.direction.x - speed * axisX;
            var acrossY:Number = ray.direction.y - speed * axisY;
            var acrossZ:Number = ray.direction.z - speed * axisZ;
            var acrossSquared:Number = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
            out.setPlaces(-Infinity, Infinity);
            if (acrossSquared > Tolerances.PARALLEL)
            {
                // the middle of the part in the cylinder, and the vector to it from the axis, perpendicular to both
                x -= fraction * axisX;
                y -= fraction * axisY;
                z -= fraction * axisZ;
                var closestDistance:Number = -(x * acrossX + y * acrossY + z * acrossZ) / acrossSquared;
                x += closestDistance * acrossX;
                y += closestDistance * acrossY;
                z += closestDistance * acrossZ;
                var halfSquared:Number = radius * radius - (x * x + y * y + z * z);
                if (!(halfSquared >= 0))
                {
                    return false;
                }
                var half:Number = Math.sqrt(halfSquared / acrossSquared);
                out.setPlaces(closestDistance - half, closestDistance + half);
                out.near.normal.setTo(x - half * acrossX, y - half * acrossY, z - half * acrossZ);
                out.far.normal.setTo(x + half * acrossX, y + half * acrossY, z + half * acrossZ);
            }
            var nearFraction:Number = fraction + out.near.touchDistance * speed;
            var farFraction:Number = fraction + out.far.touchDistance * speed;
            var isNearOnSide:Boolean = nearFraction >= 0 && nearFraction <= 1;
            var isFarOnSide:Boolean = farFraction >= 0 && farFraction <= 1;
            var isInNearBall:Boolean = !isNearOnSide && findInBall(ray, nearFraction > 1 ? end : start, radius, BALL);
            if (isInNearBall)
            {
                out.near.copyFrom(BALL.near);
            }
            var isInFarBall:Boolean = !isFarOnSide && (isNearOnSide || isInNearBall) && findInBall(ray, farFraction > 1 ? end : start, radius, BALL);
            if (isInFarBall)
            {
                out.far.copyFrom(BALL.far);
            }
            // A line through the side meets the ball too that it passes at its other end. If rounding says no, that is at the rim: the cylinder's end stays.
            return isNearOnSide || isFarOnSide || isInFarBall;
        }

        /**
         * Finds the part of the line inside of a box: where it is between all three pairs of faces (Kay and Kajiya, "Ray tracing complex scenes",
         * SIGGRAPH 1986).
         *
         * @param ray in the space of the box
         * @param box half-extents may be 0
         * @param touchingFactor the factor on the half-extents at which the line still touches the box
         * @param out receives the part
         * @return whether the line meets the box
         */
        public static function findInBox(ray:Ray, box:Box, touchingFactor:Number, out:RaySpan):Boolean
        {
            var center:Vector3D = box.center;
            var entered:Vector3D = null;
            var exited:Vector3D = null;
            var touchNear:Number = -Infinity;
            var touchFar:Number = Infinity;
            var crossNear:Number = -Infinity;
            var crossFar:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                var axis:Vector3D = i == 0 ? box.axisX : i == 1 ? box.axisY : box.axisZ;
                var half:Number = i == 0 ? box.halfX : i == 1 ? box.halfY : box.halfZ;
                var offset:Number = axis.x * (ray.origin.x - center.x) + axis.y * (ray.origin.y - center.y) + axis.z * (ray.origin.z - center.z);
                var speed:Number = axis.x * ray.direction.x + axis.y * ray.direction.y + axis.z * ray.direction.z;
                // a line within the planes crosses them at an infinite distance, if its speed is not -0
                speed = speed == 0 ? 0 : speed;
                var ahead:Number = speed < 0 ? -half : half;
                var distance:Number = (-ahead - offset) / speed;
                crossNear = distance > crossNear && distance < Infinity ? distance : crossNear;
                distance = (ahead - offset) / speed;
                crossFar = distance < crossFar && distance > -Infinity ? distance : crossFar;
                ahead *= touchingFactor;
                distance = (-ahead - offset) / speed;
                if (distance > touchNear)
                {
                    touchNear = distance;
                    entered = axis;
                }
                distance = (ahead - offset) / speed;
                if (distance < touchFar)
                {
                    touchFar = distance;
                    exited = axis;
                }
            }
            if (!(touchNear <= touchFar))
            {
                return false;
            }
            setPlacesOfFaces(touchNear, crossNear, crossFar, touchFar, out);
            out.near.normal.setTo(entered.x, entered.y, entered.z);
            out.far.normal.setTo(exited.x, exited.y, exited.z);
            return true;
        }

        // Where the line is inside of all half-spaces of a hull (Cyrus and Beck, "Generalized two- and three-dimensional clipping", Computers & Graphics,
        // 1978). It touches a half-space to within the factor on the plane's distance from the centre.
        private static function findInHull(ray:Ray, hull:Hull, out:RaySpan):Boolean
        {
            var center:Vector3D = hull.center;
            var x:Number = ray.origin.x - center.x;
            var y:Number = ray.origin.y - center.y;
            var z:Number = ray.origin.z - center.z;
            var planes:Vector.<Number> = hull.halfSpaces;
            var end:int = planes.length;
            var entered:int = 0;
            var exited:int = 0;
            var touchNear:Number = -Infinity;
            var touchFar:Number = Infinity;
            var crossNear:Number = -Infinity;
            var crossFar:Number = Infinity;
            for (var i:int = 0; i < end; i += 4)
            {
                var height:Number = planes[i] * x + planes[int(i + 1)] * y + planes[int(i + 2)] * z - planes[int(i + 3)] - hull.radius;
                var speed:Number = planes[i] * ray.direction.x + planes[int(i + 1)] * ray.direction.y + planes[int(i + 2)] * ray.direction.z;
                var touchingHeight:Number = height - (Tolerances.TOUCHING - 1) * planes[int(i + 3)];
                if (speed == 0)
                {
                    touchFar = touchingHeight > 0 ? -Infinity : touchFar;
                    continue;
                }
                var crossed:Number = -height / speed;
                var touched:Number = -touchingHeight / speed;
                if (speed < 0)
                {
                    crossNear = crossed > crossNear ? crossed : crossNear;
                    if (touched > touchNear)
                    {
                        touchNear = touched;
                        entered = i;
                    }
                }
                else
                {
                    crossFar = crossed < crossFar ? crossed : crossFar;
                    if (touched < touchFar)
                    {
                        touchFar = touched;
                        exited = i;
                    }
                }
            }
            if (!(touchNear <= touchFar))
            {
                return false;
            }
            setPlacesOfFaces(touchNear, crossNear, crossFar, touchFar, out);
            out.near.normal.setTo(planes[entered], planes[int(entered + 1)], planes[int(entered + 2)]);
            out.far.normal.setTo(planes[exited], planes[int(exited + 1)], planes[int(exited + 2)]);
            return true;
        }

        // Sets the ends for a shape with flat faces. The planes of the shape itself say nothing about a line that passes beside it and only touches it.
        private static function setPlacesOfFaces(touchNear:Number, crossNear:Number, crossFar:Number, touchFar:Number, out:RaySpan):void
        {
            out.near.touchDistance = touchNear;
            out.far.touchDistance = touchFar;
            out.near.surfaceDistance = crossNear > touchNear && crossNear <= touchFar ? crossNear : touchNear;
            out.far.surfaceDistance = crossFar < touchFar && crossFar >= out.near.surfaceDistance ? crossFar : touchFar;
        }
    }
}

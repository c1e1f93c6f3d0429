package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactFeature;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the shortest displacement that separates two structures that are sums of segments: two boxes, two axes of capsules, or a capsule's
     * axis and a box. It is perpendicular to two of the segments' directions. So it is perpendicular to a face of one structure, or to an
     * edge of each.
     *
     * @private
     */
    public final class LeastOverlap
    {
        private var _a:Zonotope = new Zonotope();
        private var _b:Zonotope = new Zonotope();
        private var _featureA:ContactFeature = new ContactFeature();
        private var _featureB:ContactFeature = new ContactFeature();
        private var _direction:Vector3D = new Vector3D();

        // The direction of the shortest displacement so far, and its length without the radius.
        private var _best:Vector3D = new Vector3D();
        private var _depth:Number = Infinity;

        /**
         * Finds the contact of two boxes, or of a capsule and a box if the capsule's axis passes through the box.
         *
         * @param a a Box or a Capsule
         * @param b a Box
         * @param displacement moves a from its stored place
         * @param out receives the contact
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            findNormal(a, b, displacement, out);
            _b.supportInto(_featureB, _best);
            _direction.setTo(-_best.x, -_best.y, -_best.z);
            _a.supportInto(_featureA, _direction);
            _featureA.findCommonPoint(_featureB, out);
            // halfway between the two surfaces
            var radius:Number = _a.radius;
            out.x -= radius / 2 * out.normalX;
            out.y -= radius / 2 * out.normalY;
            out.z -= radius / 2 * out.normalZ;
            var depth:Number = _depth + radius;
            out.depth = depth > 0 ? depth : 0;
        }

        /**
         * Finds the normal of the contact of two structures. If they are axes that are parallel, the normal points upwards as far as possible.
         *
         * @param a a Box, or a Capsule whose axis is meant
         * @param b a Box, or a Capsule whose axis is meant
         * @param displacement moves a from its stored place
         * @param out receives the normal
         */
        public function findNormal(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            _a.setTo(a, displacement);
            _b.setTo(b, RelativeMotion.NONE);
            _depth = Infinity;
            tryAll(_b, _b);
            tryAll(_a, _a);
            tryAll(_a, _b);
            if (_depth == Infinity)
            {
                tryAcross(_a, out);
                tryAcross(_b, out);
            }
            out.setNormal(_best.x, _best.y, _best.z);
        }

        // Tries the direction across an axis that points upwards as far as possible.
        private function tryAcross(axis:Zonotope, scratch:ContactPoint):void
        {
            scratch.setNormal(axis.directions[0], axis.directions[1], axis.directions[2]);
            scratch.makePerpendicular();
            _direction.setTo(scratch.normalX, scratch.normalY, scratch.normalZ);
            tryAlong(_direction);
        }

        // Tries the cross products of each two directions.
        private function tryAll(first:Zonotope, second:Zonotope):void
        {
            var u:Vector.<Number> = first.directions;
            var v:Vector.<Number> = second.directions;
            var direction:Vector3D = _direction;
            for (var i:int = 0; i < first.end; i += 3)
            {
                var ux:Number = u[i];
                var uy:Number = u[int(i + 1)];
                var uz:Number = u[int(i + 2)];
                for (var k:int = first === second ? i + 3 : 0; k < second.end; k += 3)
                {
                    var vx:Number = v[k];
                    var vy:Number = v[int(k + 1)];
                    var vz:Number = v[int(k + 2)];
                    direction.x = uy * vz - uz * vy;
                    direction.y = uz * vx - ux * vz;
                    direction.z = ux * vy - uy * vx;
                    tryAlong(direction);
                }
            }
        }

        // Normalises a direction, and takes it if it is better. Its length is the sine of the angle between two segments.
        private function tryAlong(direction:Vector3D):void
        {
            var x:Number = direction.x;
            var y:Number = direction.y;
            var z:Number = direction.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length < Tolerances.DIRECTION)
            {
                return;
            }
            x /= length;
            y /= length;
            z /= length;
            var along:Number = (_a.x - _b.x) * x + (_a.y - _b.y) * y + (_a.z - _b.z) * z;
            if (along < 0)
            {
                along = -along;
                x = -x;
                y = -y;
                z = -z;
            }
            direction.x = x;
            direction.y = y;
            direction.z = z;
            _a.measure(direction);
            _b.measure(direction);
            var reach:Number = _a.reach + _b.reach;
            // A difference as small as the rounding error does not count as shorter.
            if (reach - along < _depth - Tolerances.ROUNDING * reach)
            {
                _depth = reach - along;
                _best.x = x;
                _best.y = y;
                _best.z = z;
            }
        }
    }
}

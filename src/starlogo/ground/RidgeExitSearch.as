package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;
    import starlogo.solid.SupportPoint;

    /**
     * Finds the exit of a convex model across a ridge: where two planes of the ground meet, an edge of the model lies across. What is farthest behind each plane is
     * on the other side of the ridge. The exit is perpendicular to both edges.
     */
    internal final class RidgeExitSearch
    {
        // How many edges of the model are tried.
        private static const MAX_STEPS:int = 6;

        // The ends of the edge: the one behind plane A, and the one behind plane B.
        private var _behindA:SupportPoint = new SupportPoint();
        private var _behindB:SupportPoint = new SupportPoint();

        // A direction across the ridge, and the component of the ridge's points along it.
        private var _across:Vector3D = new Vector3D();
        private var _ridge:Number = 0;

        /**
         * Finds the exit.
         *
         * @param model where it stands
         * @param a a plane, with the point of the model that is farthest behind it
         * @param b another plane, with its point
         * @param out receives the plane of the exit, through the line where the two planes meet, and the point of the edge that is farthest behind it
         * @return whether the model has such an edge
         */
        public function find(model:ModelPiece, a:GroundPlane, b:GroundPlane, out:GroundPlane):Boolean
        {
            var tolerance:Number = Tolerances.SEPARATION / 10 * model.box.halfZ;
            _behindA.copyFrom(a.point);
            _behindB.copyFrom(b.point);
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                if (!findPlane(a, b, out))
                {
                    return false;
                }
                out.findPoint(model);
                findAcross(a, b, out);
                if (-out.point.support >= along(out.normal, _behindA) - tolerance)
                {
                    out.isPointOfModel = model.tree == null;
                    return findCrossing(out.point);
                }
                var replaced:SupportPoint = _ridge > along(_across, out.point) ? _behindB : _behindA;
                replaced.copyFrom(out.point);
            }
            return false;
        }

        // Finds the plane through the ridge that is parallel to the edge. Returns false if its normal is not between those of the two planes.
        private function findPlane(a:GroundPlane, b:GroundPlane, out:GroundPlane):Boolean
        {
            var x:Number = _behindB.x - _behindA.x;
            var y:Number = _behindB.y - _behindA.y;
            var z:Number = _behindB.z - _behindA.z;
            // the shares of the two normals in the one that is perpendicular to both edges
            var shareA:Number = -(b.normal.x * x + b.normal.y * y + b.normal.z * z);
            var shareB:Number = a.normal.x * x + a.normal.y * y + a.normal.z * z;
            out.normal.x = shareA * a.normal.x + shareB * b.normal.x;
            out.normal.y = shareA * a.normal.y + shareB * b.normal.y;
            out.normal.z = shareA * a.normal.z + shareB * b.normal.z;
            var length:Number = out.normal.normalize();
            out.offset = (shareA * a.offset + shareB * b.offset) / length;
            return shareA >= 0 && shareB >= 0 && length > 0;
        }

        // Finds the direction in the plane of the exit that leads from A to B across the ridge, and where the ridge is along it.
        private function findAcross(a:GroundPlane, b:GroundPlane, exit:GroundPlane):void
        {
            var normal:Vector3D = exit.normal;
            var x:Number = b.normal.x - a.normal.x;
            var y:Number = b.normal.y - a.normal.y;
            var z:Number = b.normal.z - a.normal.z;
            var cosine:Number = x * normal.x + y * normal.y + z * normal.z;
            _across.x = x - cosine * normal.x;
            _across.y = y - cosine * normal.y;
            _across.z = z - cosine * normal.z;
            _ridge = b.offset - a.offset - cosine * exit.offset;
        }

        // Finds the point of the edge that is over the ridge. Returns false if the edge ends before it.
        private function findCrossing(out:SupportPoint):Boolean
        {
            var x:Number = _behindB.x - _behindA.x;
            var y:Number = _behindB.y - _behindA.y;
            var z:Number = _behindB.z - _behindA.z;
            var ofA:Number = along(_across, _behindA);
            var ofB:Number = ofA + _across.x * x + _across.y * y + _across.z * z;
            var fraction:Number = (_ridge - ofA) / (ofB - ofA);
            out.x = _behindA.x + fraction * x;
            out.y = _behindA.y + fraction * y;
            out.z = _behindA.z + fraction * z;
            return fraction >= 0 && fraction <= 1;
        }

        // The component of a point along a direction.
        private static function along(direction:Vector3D, point:SupportPoint):Number
        {
            return direction.x * point.x + direction.y * point.y + direction.z * point.z;
        }
    }
}

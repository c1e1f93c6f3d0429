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

        // The ends of the edge.
        private var _behindA:SupportPoint = new SupportPoint();
        private var _behindB:SupportPoint = new SupportPoint();

        /**
         * Finds the exit.
         *
         * @param model where it stands
         * @param a a plane, with the point of the model that is farthest behind it
         * @param b another plane, with its point
         * @param out receives the exit. Its plane goes through the line where the two planes meet
         * @return whether the model has such an edge
         */
        public function find(model:ModelPiece, a:GroundExit, b:GroundExit, out:GroundExit):Boolean
        {
            var tolerance:Number = Tolerances.SEPARATION / 10 * model.box.halfZ;
            var normal:Vector3D = out.normal;
            _behindA.copyFrom(a.point);
            _behindB.copyFrom(b.point);
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                var x:Number = _behindB.x - _behindA.x;
                var y:Number = _behindB.y - _behindA.y;
                var z:Number = _behindB.z - _behindA.z;
                // the shares of the two normals in the one that is perpendicular to both edges
                var shareA:Number = -(b.normal.x * x + b.normal.y * y + b.normal.z * z);
                var shareB:Number = a.normal.x * x + a.normal.y * y + a.normal.z * z;
                normal.x = shareA * a.normal.x + shareB * b.normal.x;
                normal.y = shareA * a.normal.y + shareB * b.normal.y;
                normal.z = shareA * a.normal.z + shareB * b.normal.z;
                var length:Number = normal.normalize();
                if (!(shareA >= 0 && shareB >= 0 && length > 0))
                {
                    return false;
                }
                out.offset = (shareA * a.offset + shareB * b.offset) / length;
                out.findPoint(model);
                // how far the line is from the ends of the edge, along the direction that leads from A to B across the ridge
                var acrossX:Number = b.normal.x - a.normal.x;
                var acrossY:Number = b.normal.y - a.normal.y;
                var acrossZ:Number = b.normal.z - a.normal.z;
                var cosine:Number = acrossX * normal.x + acrossY * normal.y + acrossZ * normal.z;
                acrossX -= cosine * normal.x;
                acrossY -= cosine * normal.y;
                acrossZ -= cosine * normal.z;
                var line:Number = b.offset - a.offset - cosine * out.offset;
                if (-out.point.support >= normal.x * _behindA.x + normal.y * _behindA.y + normal.z * _behindA.z - tolerance)
                {
                    var ofA:Number = acrossX * _behindA.x + acrossY * _behindA.y + acrossZ * _behindA.z;
                    var ofB:Number = ofA + acrossX * x + acrossY * y + acrossZ * z;
                    var fraction:Number = (line - ofA) / (ofB - ofA);
                    out.point.x = _behindA.x + fraction * x;
                    out.point.y = _behindA.y + fraction * y;
                    out.point.z = _behindA.z + fraction * z;
                    out.isPointOfModel = model.tree == null;
                    return fraction >= 0 && fraction <= 1;
                }
                if (line > acrossX * out.point.x + acrossY * out.point.y + acrossZ * out.point.z)
                {
                    _behindB.copyFrom(out.point);
                }
                else
                {
                    _behindA.copyFrom(out.point);
                }
            }
            return false;
        }
    }
}

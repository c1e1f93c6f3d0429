package support
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.TrianglePairDistance;
    import starlogo.intersection.triangleTriangle;
    import starlogo.models.Model;

    use namespace engine;

    /** Whether the surfaces of two agents meet, found out with every triangle against every other. */
    public final class EveryTriangle
    {
        private static var sCornersA:Vector.<Number> = new Vector.<Number>();
        private static var sCornersB:Vector.<Number> = new Vector.<Number>();
        private static var sClosest:TrianglePairDistance = new TrianglePairDistance();

        /** Whether the models of two agents meet where these stand. */
        public static function meet(a:Agent, modelA:Model, b:Agent, modelB:Model):Boolean
        {
            place(a.worldPlacement(), modelA, sCornersA);
            place(b.worldPlacement(), modelB, sCornersB);
            var extents:Vector.<Number> = extentsOf(sCornersB);
            sClosest.reach = 1e-12;
            for (var i:int = 0; i < sCornersA.length; i += 9)
            {
                if (!isOver(sCornersA[i], sCornersA[i + 3], sCornersA[i + 6], extents[0], extents[3])
                        || !isOver(sCornersA[i + 1], sCornersA[i + 4], sCornersA[i + 7], extents[1], extents[4])
                        || !isOver(sCornersA[i + 2], sCornersA[i + 5], sCornersA[i + 8], extents[2], extents[5]))
                {
                    continue;
                }
                var minX:Number = Math.min(sCornersA[i], sCornersA[i + 3], sCornersA[i + 6]);
                var maxX:Number = Math.max(sCornersA[i], sCornersA[i + 3], sCornersA[i + 6]);
                var minY:Number = Math.min(sCornersA[i + 1], sCornersA[i + 4], sCornersA[i + 7]);
                var maxY:Number = Math.max(sCornersA[i + 1], sCornersA[i + 4], sCornersA[i + 7]);
                var length:int = sCornersB.length;
                for (var j:int = 0; j < length; j += 9)
                {
                    if (isOver(sCornersB[j], sCornersB[int(j + 3)], sCornersB[int(j + 6)], minX, maxX)
                            && isOver(sCornersB[int(j + 1)], sCornersB[int(j + 4)], sCornersB[int(j + 7)], minY, maxY)
                            && triangleTriangle(sCornersA, i, sCornersB, j, sClosest))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        // minX, minY, minZ, maxX, maxY, maxZ
        private static function extentsOf(corners:Vector.<Number>):Vector.<Number>
        {
            var extents:Vector.<Number> = new <Number>[Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
            for (var i:int = 0; i < corners.length; i++)
            {
                extents[i % 3] = Math.min(extents[i % 3], corners[i]);
                extents[3 + i % 3] = Math.max(extents[3 + i % 3], corners[i]);
            }
            return extents;
        }

        private static function isOver(p:Number, q:Number, r:Number, min:Number, max:Number):Boolean
        {
            return !(p > max && q > max && r > max || p < min && q < min && r < min);
        }

        /** Writes the corners of all triangles of a model where it stands, nine numbers each. */
        public static function place(placement:Placement, model:Model, out:Vector.<Number>):void
        {
            out.length = 0;
            for (var i:int = 0; i < model.triangles.length; i++)
            {
                var at:int = 3 * model.triangles[i];
                var x:Number = placement.size * model.vertices[at];
                var y:Number = placement.size * model.vertices[at + 1];
                var z:Number = placement.size * model.vertices[at + 2];
                out.push(placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x,
                        placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y,
                        placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z);
            }
        }
    }
}

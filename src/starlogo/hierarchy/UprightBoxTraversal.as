package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Decides whether two standing trees overlap if their models are rotated about z only, as almost always.
     *
     * <p>It works like BoxTraversal, but there are only five axes, and three of them take few products. It is written out, because
     * BoxTraversal takes a quarter longer for such pairs, and a branch in its loop gains nothing (TraversalBenchmark).</p>
     *
     * @private
     */
    public final class UprightBoxTraversal extends NodePairTraversal
    {
        /**
         * @inheritDoc
         *
         * <p>The steps for a pair are: the gap along z; whether b's middle is over a; the other faces of a; the faces of b.</p>
         */
        override public function find(pose:RelativePose, a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, leaves:LeafTest):Boolean
        {
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var cos:Number = relative.r00 * scale;
            var sin:Number = relative.r10 * scale;
            var m00:Number = cos;
            var m01:Number = -sin;
            var m02:Number = 0;
            var m10:Number = sin;
            var m11:Number = cos;
            var m12:Number = 0;
            var m20:Number = 0;
            var m21:Number = 0;
            var m22:Number = scale;
            var widened:Number = Tolerances.ROUNDING * scale;
            var absCos:Number = cos < 0 ? widened - cos : widened + cos;
            var absSin:Number = sin < 0 ? widened - sin : widened + sin;
            var scaleSquared:Number = scale * scale;
            var touching:Number = pose.gap;
            var stack:Vector.<HierarchyNode> = nodes;
            var top:int = 0;
            var visits:int = 0;
            while (true)
            {
                visits++;
                // These are set in each iteration. Otherwise V8 keeps them as objects from one iteration to the next.
                var overlap:Boolean = false;
                var isDeep:Boolean = false;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = scale * b.z + moveZ - a.z;
                var reach:Number = a.halfZ + touching + scale * b.halfZ;
                if (z <= reach)
                {
                    if (z >= -reach)
                    {
                        var bX:Number = b.x;
                        var bY:Number = b.y;
                        x = cos * bX - sin * bY + moveX - a.x;
                        y = sin * bX + cos * bY + moveY - a.y;
                        var halfX:Number = a.halfX + touching;
                        var halfY:Number = a.halfY + touching;
                        var distanceX:Number = x < 0 ? -x : x;
                        var distanceY:Number = y < 0 ? -y : y;
                        if (distanceX <= halfX)
                        {
                            isDeep = distanceY <= halfY;
                        }
                        overlap = isDeep;
                        if (!isDeep)
                        {
                            bX = b.halfX;
                            bY = b.halfY;
                            if (distanceX <= halfX + absCos * bX + absSin * bY)
                            {
                                if (distanceY <= halfY + absSin * bX + absCos * bY)
                                {
                                    var along:Number = cos * x + sin * y;
                                    reach = scaleSquared * bX + absCos * halfX + absSin * halfY;
                                    if (along <= reach)
                                    {
                                        if (along >= -reach)
                                        {
                                            along = cos * y - sin * x;
                                            reach = scaleSquared * bY + absSin * halfX + absCos * halfY;
                                            if (along <= reach)
                                            {
                                                overlap = along >= -reach;
                                            }
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
                include "goOn.inc";
            }
            return false;
        }
    }
}

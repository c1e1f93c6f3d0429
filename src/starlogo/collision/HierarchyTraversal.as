package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.intersects;
    import starlogo.intersection.triangleTriangle;
    import starlogo.libraries.Hierarchy;
    import starlogo.libraries.HierarchyNode;

    use namespace engine;

    /**
     * Decides whether two hierarchies meet, or one and a structure (thesis §4.6): depth-first, until two nodes that are
     * leaves or at their depth limit overlap.
     *
     * <p>The thesis puts both structures into the world for each pair of nodes (§4.5). Here one transform per pair of
     * agents takes the second model into the space of the first, where the first's boxes are axis-aligned and the
     * second's all turned alike: a pair of boxes then takes a few products (Gottschalk, Lin and Manocha, "OBBTree",
     * SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", §4.4.1). Of two nodes that overlap the larger is divided,
     * and the child that is nearer to the other node is looked at first. The axes of the edges are tried only where the
     * boxes decide: higher up, what they would separate is mostly separated by the next boxes (van den Bergen,
     * "Efficient collision detection of complex deformable models using AABB trees", 1997).</p>
     *
     * <p>Its scratch objects are reused: it allocates nothing once its stack has grown.</p>
     */
    internal final class HierarchyTraversal
    {
        /** Pairs that were decided. */
        public var pairs:int;

        /** Pairs of nodes that were visited. */
        public var nodeVisits:int;

        /** Pairs of triangles that were tested. */
        public var triangleTests:int;

        // Takes the second model into the space of the first; and whether both are turned about z only, as almost always.
        private var _relative:Placement = new Placement();
        private var _isUpright:Boolean;

        // The rows of its rotation, scaled, and their absolute values, those widened by a rounding error: it makes up for
        // cross products of nearly parallel edges, which cancel (Ericson, §4.4.1).
        private var _m00:Number;
        private var _m01:Number;
        private var _m02:Number;
        private var _m10:Number;
        private var _m11:Number;
        private var _m12:Number;
        private var _m20:Number;
        private var _m21:Number;
        private var _m22:Number;
        private var _abs00:Number;
        private var _abs01:Number;
        private var _abs02:Number;
        private var _abs10:Number;
        private var _abs11:Number;
        private var _abs12:Number;
        private var _abs20:Number;
        private var _abs21:Number;
        private var _abs22:Number;

        private var _stack:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        // A box that stands for a model, with its own axes.
        private var _leaf:HierarchyNode = new HierarchyNode();

        // By kind: a structure of the second model in the space of the first.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0),
                new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0)];

        // The triangles of a leaf of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _cornersOf:HierarchyNode;
        private var _touching:Number;

        /** Nothing counted yet. */
        public function HierarchyTraversal()
        {
            _relative.isUpright = false;
            _leaf.level = 1;
            _leaf.x = _leaf.y = _leaf.z = 0;
        }

        /** Begins to count. */
        public function resetCounts():void
        {
            pairs = nodeVisits = triangleTests = 0;
        }

        /** Reports the counts. */
        public function countInto(statistics:CollisionStatistics):void
        {
            statistics.hierarchyTests = pairs;
            statistics.nodeVisits = nodeVisits;
            statistics.triangleTests = triangleTests;
        }

        /**
         * Whether two bodies meet of which one is hierarchical at least. The answer does not depend on their order.
         *
         * @param first a body
         * @param second another body
         * @param maxDepth how many levels are visited of those whose agents have no depth of their own; the root is one
         * @param exact whether, for two hierarchies of triangles, depths do not count, triangles decide, and a model inside
         *     of a closed one meets it
         */
        public function bodiesMeet(first:Body, second:Body, maxDepth:int, exact:Boolean):Boolean
        {
            var bodyA:Body = first;
            var bodyB:Body = second;
            if (first.serial > second.serial)
            {
                bodyA = second;
                bodyB = first;
            }
            pairs++;
            if (!bodyA.isHierarchical)
            {
                return structureMeets(bodyB, bodyB.depth == 0 ? maxDepth : bodyB.depth, bodyA);
            }
            var depthA:int = bodyA.depth == 0 ? maxDepth : bodyA.depth;
            if (!bodyB.isHierarchical)
            {
                return structureMeets(bodyA, depthA, bodyB);
            }
            var depthB:int = bodyB.depth == 0 ? maxDepth : bodyB.depth;
            relate(bodyA.agent.placement, bodyB.agent.placement);
            var a:Hierarchy = bodyA.hierarchy;
            var b:Hierarchy = bodyB.hierarchy;
            if (exact)
            {
                exact = prepareTriangles(a, b);
                if (exact)
                {
                    depthA = depthB = int.MAX_VALUE;
                }
            }
            var meet:Boolean;
            if (a.boundsKind != BoundingStructure.BOX || b.boundsKind != BoundingStructure.BOX)
            {
                meet = structuresMeet(a.root, depthA, b.root, depthB, exact);
            }
            else if (_isUpright)
            {
                meet = uprightBoxesMeet(a.root, depthA, b.root, depthB, exact);
            }
            else
            {
                meet = boxesMeet(a.root, depthA, b.root, depthB, exact);
            }
            return meet || (exact && (isInside(b, a) || isInsideOut(a, b)));
        }

        private function prepareTriangles(a:Hierarchy, b:Hierarchy):Boolean
        {
            if (!a.hasTriangles || !b.hasTriangles)
            {
                return false;
            }
            a.prepareTriangles();
            b.prepareTriangles();
            _cornersOf = null;
            _touching = Tolerances.SURFACES * (a.root.radius + b.root.radius * _relative.size);
            return true;
        }

        // Whether a hierarchy meets the structure of another body.
        private function structureMeets(hierarchical:Body, depthA:int, other:Body):Boolean
        {
            var a:Hierarchy = hierarchical.hierarchy;
            var structure:BoundingStructure = other.structure;
            relate(hierarchical.agent.placement, other.agent.placement);
            if (structure.kind == BoundingStructure.BOX && a.boundsKind == BoundingStructure.BOX)
            {
                relateToAxesOf(structure as Box);
                return boxesMeet(a.root, depthA, _leaf, 1, false);
            }
            var moved:BoundingStructure = structure.place(_relative, _moved[structure.kind]);
            var stack:Vector.<HierarchyNode> = _stack;
            var node:HierarchyNode = a.root;
            var top:int = 0;
            while (true)
            {
                nodeVisits++;
                if (intersects(structureOf(node), moved))
                {
                    if (node.endLevel >= depthA)
                    {
                        return true;
                    }
                    var next:HierarchyNode = nearerChild(node, moved);
                    stack[top++] = next === node.left ? node.right : node.left;
                    node = next;
                }
                else if (top == 0)
                {
                    return false;
                }
                else
                {
                    node = stack[--top];
                }
            }
            return false;
        }

        // Where the second model's origin and axes are in the first model's space.
        private function relate(a:Placement, b:Placement):void
        {
            var a00:Number = a.r00;
            var a01:Number = a.r01;
            var a10:Number = a.r10;
            var a11:Number = a.r11;
            var b00:Number = b.r00;
            var b01:Number = b.r01;
            var b10:Number = b.r10;
            var b11:Number = b.r11;
            var scale:Number = b.size / a.size;
            var x:Number = (b.x - a.x) / a.size;
            var y:Number = (b.y - a.y) / a.size;
            var z:Number = (b.z - a.z) / a.size;
            var relative:Placement = _relative;
            relative.size = scale;
            _isUpright = a.r20 == 0 && a.r21 == 0 && a.r22 == 1 && b.r20 == 0 && b.r21 == 0 && b.r22 == 1;
            if (_isUpright)
            {
                // the other entries are exactly 0
                relative.x = a00 * x + a10 * y;
                relative.y = a01 * x + a11 * y;
                relative.z = z;
                relative.r00 = a00 * b00 + a10 * b10;
                relative.r01 = a00 * b01 + a10 * b11;
                relative.r10 = a01 * b00 + a11 * b10;
                relative.r11 = a01 * b01 + a11 * b11;
                relative.r02 = relative.r12 = relative.r20 = relative.r21 = 0;
                relative.r22 = 1;
                return;
            }
            var a02:Number = a.r02;
            var a12:Number = a.r12;
            var a20:Number = a.r20;
            var a21:Number = a.r21;
            var a22:Number = a.r22;
            var b02:Number = b.r02;
            var b12:Number = b.r12;
            var b20:Number = b.r20;
            var b21:Number = b.r21;
            var b22:Number = b.r22;
            relative.x = a00 * x + a10 * y + a20 * z;
            relative.y = a01 * x + a11 * y + a21 * z;
            relative.z = a02 * x + a12 * y + a22 * z;
            relative.r00 = a00 * b00 + a10 * b10 + a20 * b20;
            relative.r01 = a00 * b01 + a10 * b11 + a20 * b21;
            relative.r02 = a00 * b02 + a10 * b12 + a20 * b22;
            relative.r10 = a01 * b00 + a11 * b10 + a21 * b20;
            relative.r11 = a01 * b01 + a11 * b11 + a21 * b21;
            relative.r12 = a01 * b02 + a11 * b12 + a21 * b22;
            relative.r20 = a02 * b00 + a12 * b10 + a22 * b20;
            relative.r21 = a02 * b01 + a12 * b11 + a22 * b21;
            relative.r22 = a02 * b02 + a12 * b12 + a22 * b22;
        }

        // Takes the box for a leaf in a space of its own, that of its axes.
        private function relateToAxesOf(box:Box):void
        {
            var relative:Placement = _relative;
            var scale:Number = relative.size;
            var r00:Number = relative.r00;
            var r01:Number = relative.r01;
            var r02:Number = relative.r02;
            var r10:Number = relative.r10;
            var r11:Number = relative.r11;
            var r12:Number = relative.r12;
            var r20:Number = relative.r20;
            var r21:Number = relative.r21;
            var r22:Number = relative.r22;
            var vector:Vector3D = box.center;
            var x:Number = vector.x * scale;
            var y:Number = vector.y * scale;
            var z:Number = vector.z * scale;
            relative.x += r00 * x + r01 * y + r02 * z;
            relative.y += r10 * x + r11 * y + r12 * z;
            relative.z += r20 * x + r21 * y + r22 * z;
            vector = box.axisX;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            relative.r00 = r00 * x + r01 * y + r02 * z;
            relative.r10 = r10 * x + r11 * y + r12 * z;
            relative.r20 = r20 * x + r21 * y + r22 * z;
            vector = box.axisY;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            relative.r01 = r00 * x + r01 * y + r02 * z;
            relative.r11 = r10 * x + r11 * y + r12 * z;
            relative.r21 = r20 * x + r21 * y + r22 * z;
            vector = box.axisZ;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            relative.r02 = r00 * x + r01 * y + r02 * z;
            relative.r12 = r10 * x + r11 * y + r12 * z;
            relative.r22 = r20 * x + r21 * y + r22 * z;
            var leaf:HierarchyNode = _leaf;
            var middle:Vector3D = box.center;
            var distance:Number = Math.abs(middle.x) + Math.abs(middle.y) + Math.abs(middle.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            var halfX:Number = box.halfX + margin;
            var halfY:Number = box.halfY + margin;
            var halfZ:Number = box.halfZ + margin;
            leaf.halfX = halfX;
            leaf.halfY = halfY;
            leaf.halfZ = halfZ;
            leaf.radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            leaf.innerRadius = halfX < halfY ? halfX : halfY;
            if (halfZ < leaf.innerRadius)
            {
                leaf.innerRadius = halfZ;
            }
        }

        // For models that are turned about z only, as almost always: five axes are all there are, and three of them are
        // settled by few products. Otherwise like boxesMeet.
        private function uprightBoxesMeet(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, exact:Boolean):Boolean
        {
            var relative:Placement = _relative;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var cos:Number = relative.r00 * scale;
            var sin:Number = relative.r10 * scale;
            var widened:Number = Tolerances.ROUNDING * scale;
            var absCos:Number = (cos < 0 ? -cos : cos) + widened;
            var absSin:Number = (sin < 0 ? -sin : sin) + widened;
            var scaleSquared:Number = scale * scale;
            var stack:Vector.<HierarchyNode> = _stack;
            var top:int = 0;
            var visits:int = 0;
            while (true)
            {
                visits++;
                var overlap:Boolean = false;
                var z:Number = scale * b.z + moveZ - a.z;
                var reach:Number = a.halfZ + scale * b.halfZ;
                if ((z < 0 ? -z : z) <= reach)
                {
                    var bX:Number = b.x;
                    var bY:Number = b.y;
                    var x:Number = cos * bX - sin * bY + moveX - a.x;
                    var y:Number = sin * bX + cos * bY + moveY - a.y;
                    var halfX:Number = a.halfX;
                    var halfY:Number = a.halfY;
                    var distanceX:Number = x < 0 ? -x : x;
                    var distanceY:Number = y < 0 ? -y : y;
                    var isDeep:Boolean = false;
                    if (distanceX <= halfX)
                    {
                        isDeep = distanceY <= halfY;
                    }
                    if (isDeep)
                    {
                        // b's middle is over a: a child of a most likely overlaps b too, and both are divided at once
                        if (a.endLevel < depthA)
                        {
                            if (b.endLevel < depthB)
                            {
                                var axis:int = a.splitAxis;
                                var near:HierarchyNode = a.left;
                                var far:HierarchyNode = a.right;
                                if ((axis == 0 ? x : (axis == 1 ? y : z)) > 0)
                                {
                                    near = far;
                                    far = a.left;
                                }
                                stack[top] = far;
                                stack[int(top + 1)] = b;
                                stack[int(top + 2)] = near;
                                x += a.x - near.x;
                                y += a.y - near.y;
                                axis = b.splitAxis;
                                if ((axis == 0 ? cos * x + sin * y : (axis == 1 ? cos * y - sin * x : z + a.z - near.z)) < 0)
                                {
                                    stack[int(top + 3)] = b.left;
                                    b = b.right;
                                }
                                else
                                {
                                    stack[int(top + 3)] = b.right;
                                    b = b.left;
                                }
                                a = near;
                                top += 4;
                                continue;
                            }
                        }
                        overlap = true;
                    }
                    else
                    {
                        bX = b.halfX;
                        bY = b.halfY;
                        if (distanceX <= halfX + absCos * bX + absSin * bY)
                        {
                            if (distanceY <= halfY + absSin * bX + absCos * bY)
                            {
                                var along:Number = cos * x + sin * y;
                                reach = scaleSquared * bX + absCos * halfX + absSin * halfY;
                                if ((along < 0 ? -along : along) <= reach)
                                {
                                    along = cos * y - sin * x;
                                    reach = scaleSquared * bY + absSin * halfX + absCos * halfY;
                                    overlap = (along < 0 ? -along : along) <= reach;
                                }
                            }
                        }
                    }
                }
                if (overlap)
                {
                    var aEnds:Boolean = a.endLevel >= depthA;
                    var bEnds:Boolean = b.endLevel >= depthB;
                    if (aEnds && bEnds)
                    {
                        if (!exact || leavesMeet(a, b))
                        {
                            nodeVisits += visits;
                            return true;
                        }
                    }
                    else if (bEnds || (!aEnds && a.radius >= scale * b.radius))
                    {
                        axis = a.splitAxis;
                        if ((axis == 0 ? x : (axis == 1 ? y : z)) > 0)
                        {
                            stack[top] = a.left;
                            a = a.right;
                        }
                        else
                        {
                            stack[top] = a.right;
                            a = a.left;
                        }
                        stack[int(top + 1)] = b;
                        top += 2;
                        continue;
                    }
                    else
                    {
                        axis = b.splitAxis;
                        stack[top] = a;
                        if ((axis == 0 ? cos * x + sin * y : (axis == 1 ? cos * y - sin * x : z)) < 0)
                        {
                            stack[int(top + 1)] = b.left;
                            b = b.right;
                        }
                        else
                        {
                            stack[int(top + 1)] = b.right;
                            b = b.left;
                        }
                        top += 2;
                        continue;
                    }
                }
                if (top == 0)
                {
                    nodeVisits += visits;
                    return false;
                }
                top -= 2;
                a = stack[top];
                b = stack[int(top + 1)];
            }
            return false;
        }

        // The inner loop of every frame: all is in locals, and nothing is called but where boxes decide.
        private function boxesMeet(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, exact:Boolean):Boolean
        {
            var relative:Placement = _relative;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var widened:Number = Tolerances.ROUNDING * scale;
            var m00:Number = relative.r00 * scale;
            var m01:Number = relative.r01 * scale;
            var m02:Number = relative.r02 * scale;
            var m10:Number = relative.r10 * scale;
            var m11:Number = relative.r11 * scale;
            var m12:Number = relative.r12 * scale;
            var m20:Number = relative.r20 * scale;
            var m21:Number = relative.r21 * scale;
            var m22:Number = relative.r22 * scale;
            var abs00:Number = (m00 < 0 ? -m00 : m00) + widened;
            var abs01:Number = (m01 < 0 ? -m01 : m01) + widened;
            var abs02:Number = (m02 < 0 ? -m02 : m02) + widened;
            var abs10:Number = (m10 < 0 ? -m10 : m10) + widened;
            var abs11:Number = (m11 < 0 ? -m11 : m11) + widened;
            var abs12:Number = (m12 < 0 ? -m12 : m12) + widened;
            var abs20:Number = (m20 < 0 ? -m20 : m20) + widened;
            var abs21:Number = (m21 < 0 ? -m21 : m21) + widened;
            var abs22:Number = (m22 < 0 ? -m22 : m22) + widened;
            var scaleSquared:Number = scale * scale;
            var edgesAreReady:Boolean = false;
            var stack:Vector.<HierarchyNode> = _stack;
            var top:int = 0;
            var visits:int = 0;
            while (true)
            {
                visits++;

                // from the middle of a's box to that of b's
                var bX:Number = b.x;
                var bY:Number = b.y;
                var bZ:Number = b.z;
                var x:Number = m00 * bX + m01 * bY + m02 * bZ + moveX - a.x;
                var y:Number = m10 * bX + m11 * bY + m12 * bZ + moveY - a.y;
                var z:Number = m20 * bX + m21 * bY + m22 * bZ + moveZ - a.z;

                // how far b's middle is outside of a, against the spheres around b and inside of it
                var halfX:Number = a.halfX;
                var halfY:Number = a.halfY;
                var halfZ:Number = a.halfZ;
                var gapSquared:Number = 0;
                var gap:Number = (x < 0 ? -x : x) - halfX;
                if (gap > 0)
                {
                    gapSquared = gap * gap;
                }
                gap = (y < 0 ? -y : y) - halfY;
                if (gap > 0)
                {
                    gapSquared += gap * gap;
                }
                gap = (z < 0 ? -z : z) - halfZ;
                if (gap > 0)
                {
                    gapSquared += gap * gap;
                }
                var overlap:Boolean = false;
                var isDeep:Boolean = false;
                var reach:Number = scale * b.radius;
                if (gapSquared <= reach * reach)
                {
                    reach = scale * b.innerRadius;
                    if (gapSquared <= reach * reach)
                    {
                        overlap = isDeep = true;
                    }
                    else
                    {
                        // the faces of a, then those of b; all of b's times the scale
                        bX = b.halfX;
                        bY = b.halfY;
                        bZ = b.halfZ;
                        reach = halfX + abs00 * bX + abs01 * bY + abs02 * bZ;
                        if (x <= reach && x >= -reach)
                        {
                            reach = halfY + abs10 * bX + abs11 * bY + abs12 * bZ;
                            if (y <= reach && y >= -reach)
                            {
                                reach = halfZ + abs20 * bX + abs21 * bY + abs22 * bZ;
                                if (z <= reach && z >= -reach)
                                {
                                    var along:Number = m00 * x + m10 * y + m20 * z;
                                    reach = scaleSquared * bX + abs00 * halfX + abs10 * halfY + abs20 * halfZ;
                                    if (along <= reach && along >= -reach)
                                    {
                                        along = m01 * x + m11 * y + m21 * z;
                                        reach = scaleSquared * bY + abs01 * halfX + abs11 * halfY + abs21 * halfZ;
                                        if (along <= reach && along >= -reach)
                                        {
                                            along = m02 * x + m12 * y + m22 * z;
                                            reach = scaleSquared * bZ + abs02 * halfX + abs12 * halfY + abs22 * halfZ;
                                            overlap = along <= reach && along >= -reach;
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
                if (overlap)
                {
                    var aEnds:Boolean = a.endLevel >= depthA;
                    var bEnds:Boolean = b.endLevel >= depthB;
                    var axis:int;
                    if (aEnds && bEnds)
                    {
                        if (exact)
                        {
                            if (leavesMeet(a, b))
                            {
                                nodeVisits += visits;
                                return true;
                            }
                        }
                        else if (isDeep)
                        {
                            nodeVisits += visits;
                            return true;
                        }
                        else
                        {
                            if (!edgesAreReady)
                            {
                                edgesAreReady = true;
                                prepareEdges();
                            }
                            if (!areSeparatedByEdges(a, b, x, y, z))
                            {
                                nodeVisits += visits;
                                return true;
                            }
                        }
                    }
                    else if (isDeep && !aEnds && !bEnds)
                    {
                        // a child of a most likely overlaps b too: both are divided at once
                        axis = a.splitAxis;
                        var near:HierarchyNode = a.left;
                        stack[top] = a.right;
                        if ((axis == 0 ? x : (axis == 1 ? y : z)) > 0)
                        {
                            stack[top] = near;
                            near = a.right;
                        }
                        stack[int(top + 1)] = b;
                        x += a.x - near.x;
                        y += a.y - near.y;
                        z += a.z - near.z;
                        a = near;
                        axis = b.splitAxis;
                        stack[int(top + 2)] = a;
                        if ((axis == 0 ? m00 * x + m10 * y + m20 * z
                                    : (axis == 1 ? m01 * x + m11 * y + m21 * z : m02 * x + m12 * y + m22 * z)) < 0)
                        {
                            stack[int(top + 3)] = b.left;
                            b = b.right;
                        }
                        else
                        {
                            stack[int(top + 3)] = b.right;
                            b = b.left;
                        }
                        top += 4;
                        continue;
                    }
                    else if (bEnds || (!aEnds && a.radius >= scale * b.radius))
                    {
                        // the child on the side where b is
                        axis = a.splitAxis;
                        if ((axis == 0 ? x : (axis == 1 ? y : z)) > 0)
                        {
                            stack[top] = a.left;
                            a = a.right;
                        }
                        else
                        {
                            stack[top] = a.right;
                            a = a.left;
                        }
                        stack[int(top + 1)] = b;
                        top += 2;
                        continue;
                    }
                    else
                    {
                        axis = b.splitAxis;
                        stack[top] = a;
                        if ((axis == 0 ? m00 * x + m10 * y + m20 * z
                                    : (axis == 1 ? m01 * x + m11 * y + m21 * z : m02 * x + m12 * y + m22 * z)) < 0)
                        {
                            stack[int(top + 1)] = b.left;
                            b = b.right;
                        }
                        else
                        {
                            stack[int(top + 1)] = b.right;
                            b = b.left;
                        }
                        top += 2;
                        continue;
                    }
                }
                if (top == 0)
                {
                    nodeVisits += visits;
                    return false;
                }
                top -= 2;
                a = stack[top];
                b = stack[int(top + 1)];
            }
            return false;
        }

        private function prepareEdges():void
        {
            var relative:Placement = _relative;
            var scale:Number = relative.size;
            var widened:Number = Tolerances.ROUNDING * scale;
            _m00 = relative.r00 * scale;
            _m01 = relative.r01 * scale;
            _m02 = relative.r02 * scale;
            _m10 = relative.r10 * scale;
            _m11 = relative.r11 * scale;
            _m12 = relative.r12 * scale;
            _m20 = relative.r20 * scale;
            _m21 = relative.r21 * scale;
            _m22 = relative.r22 * scale;
            _abs00 = (_m00 < 0 ? -_m00 : _m00) + widened;
            _abs01 = (_m01 < 0 ? -_m01 : _m01) + widened;
            _abs02 = (_m02 < 0 ? -_m02 : _m02) + widened;
            _abs10 = (_m10 < 0 ? -_m10 : _m10) + widened;
            _abs11 = (_m11 < 0 ? -_m11 : _m11) + widened;
            _abs12 = (_m12 < 0 ? -_m12 : _m12) + widened;
            _abs20 = (_m20 < 0 ? -_m20 : _m20) + widened;
            _abs21 = (_m21 < 0 ? -_m21 : _m21) + widened;
            _abs22 = (_m22 < 0 ? -_m22 : _m22) + widened;
        }

        // The cross products of an edge of each, for boxes that their faces do not separate; all times the scale.
        private function areSeparatedByEdges(a:HierarchyNode, b:HierarchyNode, x:Number, y:Number, z:Number):Boolean
        {
            var scale:Number = _relative.size;
            var aX:Number = a.halfX;
            var aY:Number = a.halfY;
            var aZ:Number = a.halfZ;
            var bX:Number = b.halfX * scale;
            var bY:Number = b.halfY * scale;
            var bZ:Number = b.halfZ * scale;
            var along:Number = z * _m10 - y * _m20;
            var reach:Number = aY * _abs20 + aZ * _abs10 + bY * _abs02 + bZ * _abs01;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = z * _m11 - y * _m21;
            reach = aY * _abs21 + aZ * _abs11 + bZ * _abs00 + bX * _abs02;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = z * _m12 - y * _m22;
            reach = aY * _abs22 + aZ * _abs12 + bX * _abs01 + bY * _abs00;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m20 - z * _m00;
            reach = aZ * _abs00 + aX * _abs20 + bY * _abs12 + bZ * _abs11;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m21 - z * _m01;
            reach = aZ * _abs01 + aX * _abs21 + bZ * _abs10 + bX * _abs12;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m22 - z * _m02;
            reach = aZ * _abs02 + aX * _abs22 + bX * _abs11 + bY * _abs10;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m00 - x * _m10;
            reach = aX * _abs10 + aY * _abs00 + bY * _abs22 + bZ * _abs21;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m01 - x * _m11;
            reach = aX * _abs11 + aY * _abs01 + bZ * _abs20 + bX * _abs22;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m02 - x * _m12;
            reach = aX * _abs12 + aY * _abs02 + bX * _abs21 + bY * _abs20;
            return along > reach || along < -reach;
        }

        // Hierarchies of spheres or capsules, or of different structures: by the pair tests of their kinds.
        private function structuresMeet(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, exact:Boolean):Boolean
        {
            var scale:Number = _relative.size;
            var stack:Vector.<HierarchyNode> = _stack;
            var top:int = 0;
            while (true)
            {
                nodeVisits++;
                var structure:BoundingStructure = b.bounds;
                var moved:BoundingStructure = structure.place(_relative, _moved[structure.kind]);
                if (intersects(structureOf(a), moved))
                {
                    var aEnds:Boolean = a.endLevel >= depthA;
                    var bEnds:Boolean = b.endLevel >= depthB;
                    if (aEnds && bEnds)
                    {
                        if (!exact || leavesMeet(a, b))
                        {
                            return true;
                        }
                    }
                    else if (bEnds || (!aEnds && a.radius >= scale * b.radius))
                    {
                        var next:HierarchyNode = nearerChild(a, moved);
                        stack[top++] = next === a.left ? a.right : a.left;
                        stack[top++] = b;
                        a = next;
                        continue;
                    }
                    else
                    {
                        stack[top++] = a;
                        stack[top++] = b.right;
                        b = b.left;
                        continue;
                    }
                }
                if (top == 0)
                {
                    return false;
                }
                b = stack[--top];
                a = stack[--top];
            }
            return false;
        }

        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            if (node.structure != null)
            {
                return node.structure;
            }
            var box:Box = _box;
            var center:Vector3D = box.center;
            center.x = node.x;
            center.y = node.y;
            center.z = node.z;
            box.halfX = node.halfX;
            box.halfY = node.halfY;
            box.halfZ = node.halfZ;
            return box;
        }

        // On the side of the node's middle where the middle of a structure is.
        private static function nearerChild(node:HierarchyNode, structure:BoundingStructure):HierarchyNode
        {
            var at:Vector3D;
            var end:Vector3D;
            if (structure.kind == BoundingStructure.SPHERE)
            {
                at = end = Sphere(structure).center;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                at = Capsule(structure).start;
                end = Capsule(structure).end;
            }
            else
            {
                at = end = Box(structure).center;
            }
            var axis:int = node.splitAxis;
            var beyond:Number = at.z + end.z - 2 * node.z;
            if (axis == 0)
            {
                beyond = at.x + end.x - 2 * node.x;
            }
            else if (axis == 1)
            {
                beyond = at.y + end.y - 2 * node.y;
            }
            return beyond > 0 ? node.right : node.left;
        }

        // Each triangle of b that reaches into a's box, with those of a whose extents it overlaps.
        private function leavesMeet(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            if (b !== _cornersOf)
            {
                moveCorners(b);
            }
            var cornersA:Vector.<Number> = a.hierarchy.corners;
            var extents:Vector.<Number> = a.hierarchy.extents;
            var corners:Vector.<Number> = _corners;
            var touching:Number = _touching;
            var lowX:Number = a.x - a.halfX;
            var lowY:Number = a.y - a.halfY;
            var lowZ:Number = a.z - a.halfZ;
            var highX:Number = a.x + a.halfX;
            var highY:Number = a.y + a.halfY;
            var highZ:Number = a.z + a.halfZ;
            var first:int = a.first;
            var last:int = a.end;
            var length:int = 9 * (b.end - b.first);
            for (var at:int = 0; at < length; at += 9)
            {
                var p:Number = corners[at];
                var q:Number = corners[int(at + 3)];
                var r:Number = corners[int(at + 6)];
                var minX:Number = (p < q ? (p < r ? p : r) : (q < r ? q : r)) - touching;
                var maxX:Number = (p > q ? (p > r ? p : r) : (q > r ? q : r)) + touching;
                if (minX > highX || maxX < lowX)
                {
                    continue;
                }
                p = corners[int(at + 1)];
                q = corners[int(at + 4)];
                r = corners[int(at + 7)];
                var minY:Number = (p < q ? (p < r ? p : r) : (q < r ? q : r)) - touching;
                var maxY:Number = (p > q ? (p > r ? p : r) : (q > r ? q : r)) + touching;
                if (minY > highY || maxY < lowY)
                {
                    continue;
                }
                p = corners[int(at + 2)];
                q = corners[int(at + 5)];
                r = corners[int(at + 8)];
                var minZ:Number = (p < q ? (p < r ? p : r) : (q < r ? q : r)) - touching;
                var maxZ:Number = (p > q ? (p > r ? p : r) : (q > r ? q : r)) + touching;
                if (minZ > highZ || maxZ < lowZ)
                {
                    continue;
                }
                for (var i:int = first; i < last; i++)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    triangleTests++;
                    if (triangleTriangle(cornersA, 9 * i, corners, at, touching))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private function moveCorners(b:HierarchyNode):void
        {
            var from:Vector.<Number> = b.hierarchy.corners;
            var relative:Placement = _relative;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var m00:Number = relative.r00 * scale;
            var m01:Number = relative.r01 * scale;
            var m02:Number = relative.r02 * scale;
            var m10:Number = relative.r10 * scale;
            var m11:Number = relative.r11 * scale;
            var m12:Number = relative.r12 * scale;
            var m20:Number = relative.r20 * scale;
            var m21:Number = relative.r21 * scale;
            var m22:Number = relative.r22 * scale;
            var to:int = 0;
            var end:int = 9 * b.end;
            for (var i:int = 9 * b.first; i < end; i += 3)
            {
                var x:Number = from[i];
                var y:Number = from[int(i + 1)];
                var z:Number = from[int(i + 2)];
                _corners[to] = m00 * x + m01 * y + m02 * z + moveX;
                _corners[int(to + 1)] = m10 * x + m11 * y + m12 * z + moveY;
                _corners[int(to + 2)] = m20 * x + m21 * y + m22 * z + moveZ;
                to += 3;
            }
            _cornersOf = b;
        }

        // Whether a piece of the second model is inside of the first. Their surfaces do not meet.
        private function isInside(inner:Hierarchy, outer:Hierarchy):Boolean
        {
            var seeds:Vector.<Number> = inner.surface.seeds;
            var relative:Placement = _relative;
            for (var i:int = 0; outer.surface.isClosed && i < seeds.length; i += 3)
            {
                var x:Number = seeds[i] * relative.size;
                var y:Number = seeds[i + 1] * relative.size;
                var z:Number = seeds[i + 2] * relative.size;
                if (outer.isInside(relative.r00 * x + relative.r01 * y + relative.r02 * z + relative.x,
                            relative.r10 * x + relative.r11 * y + relative.r12 * z + relative.y,
                            relative.r20 * x + relative.r21 * y + relative.r22 * z + relative.z))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether a piece of the first model is inside of the second.
        private function isInsideOut(inner:Hierarchy, outer:Hierarchy):Boolean
        {
            var seeds:Vector.<Number> = inner.surface.seeds;
            var relative:Placement = _relative;
            for (var i:int = 0; outer.surface.isClosed && i < seeds.length; i += 3)
            {
                var x:Number = (seeds[i] - relative.x) / relative.size;
                var y:Number = (seeds[i + 1] - relative.y) / relative.size;
                var z:Number = (seeds[i + 2] - relative.z) / relative.size;
                if (outer.isInside(relative.r00 * x + relative.r10 * y + relative.r20 * z,
                            relative.r01 * x + relative.r11 * y + relative.r21 * z,
                            relative.r02 * x + relative.r12 * y + relative.r22 * z))
                {
                    return true;
                }
            }
            return false;
        }
    }
}

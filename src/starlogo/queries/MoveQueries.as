package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.copyVector;
    import starlogo.queries.motion.MotionResult;
    import starlogo.queries.motion.MovingBody;
    import starlogo.queries.motion.Slider;
    import starlogo.queries.motion.TouchSweep;
    import starlogo.queries.motion.WalkPlanner;
    import starlogo.queries.motion.WalkState;
    import starlogo.queries.rays.HitWriter;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go, and where a character that walks comes to stand. Some questions move the agent there. The casts
     * move nothing. AgentMotions says what each question means.
     *
     * @private
     */
    public final class MoveQueries
    {
        private static const DEFAULT_OPTIONS:WalkOptions = new WalkOptions();
        private static const UP:Vector3D = new Vector3D(0, 0, 1);

        private var _seen:SeenAgents;

        private var _slider:Slider = new Slider();
        private var _planner:WalkPlanner;
        private var _touchSweep:TouchSweep = new TouchSweep();
        private var _writer:HitWriter;

        // The body that a question moves. A walk has a body of its own.
        private var _bodyPool:NestedPool;

        /** @param seen the agents that the questions are about */
        public function MoveQueries(seen:SeenAgents)
        {
            _seen = seen;
            _writer = new HitWriter(seen, ShapeHit);
            _planner = new WalkPlanner(seen, _slider);
            _bodyPool = new NestedPool(seen, MovingBody);
        }

        /** See AgentMotions.castShape. */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return cast(currentBody().setToStructure(structure).aim(dx, dy, dz), filter, hit);
        }

        /** See AgentMotions.castShapeAll. */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter,
                out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            return castAll(currentBody().setToStructure(structure).aim(dx, dy, dz), filter, out);
        }

        /** See AgentMotions.castAgent. */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return cast(currentBody().setToCastAgent(agent).aim(dx, dy, dz), filter, hit);
        }

        /** See AgentMotions.castAgentAll. */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            return castAll(currentBody().setToCastAgent(agent).aim(dx, dy, dz), filter, out);
        }

        /** See AgentMotions.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            _seen.requireMovable(agent, "moveUntilTouch");
            var body:MovingBody = currentBody().setToAgent(agent).aim(dx, dy, dz);
            var first:MotionResult = findTouches(body, filter);
            if (first.hasContact)
            {
                _touchSweep.moveIntoTouch(body, first);
            }
            // before the contact is written, because an agent that would leave the world throws an error
            _seen.moveAgent(agent, first.place);
            if (contact != null)
            {
                contact.time = first.fraction;
                if (first.hasContact)
                {
                    contact.setFromPoint(first.contact);
                    contact.approachSpeed = Math.max(0, -first.contact.along(body.motion));
                }
            }
            return first.fraction;
        }

        /** See AgentMotions.slide. With Slider.HORIZONTAL_Z the agent stays at its height, and slopes stop it as walls do. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, minFloorNormalZ:Number = 0):Number
        {
            _seen.requireMovable(agent, "slide");
            var body:MovingBody = currentBody().setToAgent(agent).aim(dx, dy, dz);
            body.collectRowsWithin(body.motion.length, 0, 0, filter);
            var slid:MotionResult = _slider.slide(body, body.rows, body.from, body.motion, minFloorNormalZ);
            _slider.depenetration.restoreClearance(body, slid.place);
            if (minFloorNormalZ == Slider.HORIZONTAL_Z)
            {
                // the clearance leads off slopes by their normals
                slid.place.z = body.from.z;
            }
            _seen.moveAgent(agent, dx == 0 && dy == 0 && dz == 0 ? body.from : slid.place);
            return slid.fraction;
        }

        /** See AgentMotions.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            _seen.requireMovable(agent, "walk");
            var walk:WalkState = _planner.plan(agent, dx, dy, options || DEFAULT_OPTIONS);
            // before the footing is written, because an agent that would leave the world throws an error
            _seen.moveAgent(agent, walk.place, walk.carryTurn);
            var footing:Footing = writeFooting(walk, out || new Footing());
            var link:PlatformLink = agent.platformLink ||= new PlatformLink();
            link.platform = null;
            if (walk.floorRow >= ListedAgents.FIRST_LISTED)
            {
                var platform:Body = _seen.table.bodyOf(walk.floorRow);
                link.setTo(agent, footing.on, platform.placement, _seen.table.revisions[walk.floorRow]);
                if (platform.shape.ignoresRotation)
                {
                    link.platformPlacement.copyRotation(footing.on.freshPlacement());
                }
            }
            return footing;
        }

        /**
         * Finds the footing that a walk without a way would give the agent now. Nothing moves. It may be asked in a filter's <code>accepts</code>.
         */
        public function findFooting(agent:Agent, options:WalkOptions, out:Footing):Footing
        {
            return writeFooting(_planner.plan(agent, 0, 0, options), out);
        }

        // Writes how the agent stands where a walk has ended. Returns the footing.
        private function writeFooting(walk:WalkState, out:Footing):Footing
        {
            var agents:Vector.<Agent> = _seen.table.listed.agentsByRow;
            out.stands = walk.floorRow >= 0;
            out.on = out.stands ? agents[walk.floorRow] : null;
            out.against = walk.wallRow >= 0 ? agents[walk.wallRow] : null;
            out.part = walk.part;
            out.pushed = walk.pushed;
            copyVector(out.stands ? walk.floorNormal : UP, out.normal);
            return out;
        }

        // The body of the question that begins now.
        private function currentBody():MovingBody
        {
            return MovingBody(_bodyPool.top);
        }

        private function cast(body:MovingBody, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            var first:MotionResult = findTouches(body, filter);
            return first.hasContact ? writeHit(first, hit || new ShapeHit()) : null;
        }

        private function castAll(body:MovingBody, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            findTouches(body, filter);
            _writer.resize(hits, _touchSweep.count);
            for (var i:int = 0; i < hits.length; i++)
            {
                writeHit(_touchSweep.touchAt(i), hits[i]);
            }
            return hits;
        }

        // Finds how a body touches rows on a straight way. Returns the first of these results. The filter's accepts is called before, because it may ask
        // other questions, which use the same results.
        private function findTouches(body:MovingBody, filter:AgentFilter):MotionResult
        {
            body.collectRowsAlong(filter);
            return _touchSweep.findTouches(body);
        }

        private function writeHit(touch:MotionResult, hit:ShapeHit):ShapeHit
        {
            var body:Body = _seen.table.bodyOf(touch.row);
            if (body.kind != ModelShape.TREE)
            {
                // it may be a triangle of what is cast
                touch.contact.triangle = -1;
            }
            else if (touch.contact.triangle < 0)
            {
                touch.contact.triangle = _seen.narrowPhase.treeTests.findNearestTriangle(body, touch.contact);
            }
            _writer.write(touch.row, touch.contact, hit);
            hit.time = touch.fraction;
            return hit;
        }
    }
}

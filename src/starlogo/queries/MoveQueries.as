package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.queries.motion.MotionResult;
    import starlogo.queries.motion.MovingBody;
    import starlogo.queries.motion.NearRows;
    import starlogo.queries.motion.PlatformCarry;
    import starlogo.queries.motion.Slider;
    import starlogo.queries.motion.TouchFinder;
    import starlogo.queries.motion.WalkPlanner;
    import starlogo.queries.motion.WalkState;
    import starlogo.queries.rays.HitWriter;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go, and where a character that walks comes to stand. Some questions move the agent there. The casts
     * move nothing. It owns all that moves a body. AgentQueries and AgentMotions have one each, and pass such questions on. AgentMotions says what
     * each question means, and adds the tests of trees, which games that ask an AgentQueries have if they need them.
     *
     * @private
     */
    public final class MoveQueries
    {
        private static const DEFAULT_OPTIONS:WalkOptions = new WalkOptions();

        private var _seen:SeenAgents;

        private var _near:NearRows;
        private var _slider:Slider = new Slider();
        private var _platforms:PlatformCarry;
        private var _planner:WalkPlanner;
        private var _touchFinder:TouchFinder = new TouchFinder();
        private var _writer:HitWriter;

        // The body that a question moves. A walk has a body of its own.
        private var _bodyPool:NestedPool;

        /** @param seen the agents that the questions are about */
        public function MoveQueries(seen:SeenAgents)
        {
            _seen = seen;
            _near = new NearRows(seen);
            _writer = new HitWriter(seen, ShapeHit);
            _platforms = new PlatformCarry(seen, _slider);
            _planner = new WalkPlanner(seen, _near, _slider, _platforms);
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
                _touchFinder.moveIntoTouch(body, first);
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

        /** See AgentMotions.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            var body:MovingBody = beginSlide(agent, dx, dy, dz, filter);
            var slid:MotionResult = _slider.slide(body, body.rows, body.from, body.motion);
            _slider.depenetration.restoreClearance(body, slid.place);
            return endSlide(agent, body, slid);
        }

        /** Slides an agent as AgentMotions.slide does, but at its height: slopes stop it as walls do. */
        public function slideLevel(agent:Agent, dx:Number, dy:Number, filter:AgentFilter):Number
        {
            var body:MovingBody = beginSlide(agent, dx, dy, 0, filter);
            var slid:MotionResult = _slider.slideLevel(body, body.from, body.motion);
            _slider.depenetration.restoreClearance(body, slid.place);
            // the clearance leads off slopes by their normals
            slid.place.z = body.from.z;
            return endSlide(agent, body, slid);
        }

        private function beginSlide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):MovingBody
        {
            _seen.requireMovable(agent, "slide");
            var body:MovingBody = currentBody().setToAgent(agent).aim(dx, dy, dz);
            _near.findWithin(body, body.motion.length, 0, 0, filter);
            return body;
        }

        // Moves an agent to the end of a slide. Without a motion it stays where it is.
        private function endSlide(agent:Agent, body:MovingBody, slid:MotionResult):Number
        {
            var motion:Vector3D = body.motion;
            _seen.moveAgent(agent, motion.x == 0 && motion.y == 0 && motion.z == 0 ? body.from : slid.place);
            return slid.fraction;
        }

        /** See AgentMotions.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            _seen.requireMovable(agent, "walk");
            var walk:WalkState = _planner.plan(agent, dx, dy, options || DEFAULT_OPTIONS);
            // before the footing is written, because an agent that would leave the world throws an error
            _seen.moveAgent(agent, walk.place, walk.carryTurn);
            _platforms.linkToFloor(agent, walk.floorRow);
            return walk.writeFooting(_seen.table.listed.agentsByRow, out || new Footing());
        }

        /**
         * Finds the footing that a walk without a way would give the agent now. Nothing moves. It may be asked in a filter's <code>accepts</code>.
         */
        public function findFooting(agent:Agent, options:WalkOptions, out:Footing):Footing
        {
            return _planner.plan(agent, 0, 0, options).writeFooting(_seen.table.listed.agentsByRow, out);
        }

        // The body of the question that begins now.
        private function currentBody():MovingBody
        {
            return MovingBody(_bodyPool.current);
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
            _writer.resize(hits, _touchFinder.count);
            for (var i:int = 0; i < hits.length; i++)
            {
                writeHit(_touchFinder.touchAt(i), hits[i]);
            }
            return hits;
        }

        // Finds how a body touches rows on a straight way. Returns the first of these results. The filter's accepts is called before, because it may ask
        // other questions, which use the same results.
        private function findTouches(body:MovingBody, filter:AgentFilter):MotionResult
        {
            _near.findAlong(body, filter);
            return _touchFinder.findTouches(body);
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
